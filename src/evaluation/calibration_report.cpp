#include "evaluation/calibration_report.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "evaluation/text_table.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

/// A line of the table: what it is called, and what it says of an estimator.
struct Line {
  std::string title;
  std::function<std::string(const Calibration&)> cell;
};

std::string shown(const std::optional<double>& value, int digits) {
  return value ? figure(*value, digits) : "-";
}

std::string percent(double part, double all, int digits = 1) {
  return all > 0.0 ? number(100.0 * part / all, digits) : "-";
}

/// The time in any state; none of an estimator without states.
double with_state(const Calibration& c) { return std::accumulate(c.in_state.begin(), c.in_state.end(), 0.0); }

std::string median(const std::vector<double>& values) {
  return values.empty() ? "-" : number(quantile(values, 0.5), 1);
}

std::string both(const RunningMean& open, const RunningMean& shadow) {
  return shown(open.value(), 1) + " / " + shown(shadow.value(), 1);
}

void add_ellipses(std::vector<Line>& lines) {
  for (std::size_t k = 0; k < Calibration::kEllipses.size(); ++k) {
    lines.push_back({"inside the " + plain_text(100.0 * Calibration::kEllipses[k]) + " % ellipse, %",
                     [k](const Calibration& c) { return percent(c.inside[k], c.time); }});
  }
}

void add_states(std::vector<Line>& lines) {
  for (auto k = static_cast<std::size_t>(Trust::kAligning); k < Calibration::kStates; ++k) {
    const std::string state(to_string(static_cast<Trust>(k)));
    lines.push_back({state + ", % of the time (of that outside 3 sigma)", [k](const Calibration& c) {
                       return percent(c.in_state[k], with_state(c)) + " (" +
                              percent(c.beyond[k], c.in_state[k]) + ")";
                     }});
  }
  lines.push_back(
      {"minutes with GOOD; of these outside for over 2 s while GOOD, in 1000", [](const Calibration& c) {
         return std::to_string(c.good_minutes) + "; " +
                percent(10.0 * static_cast<double>(c.false_minutes), static_cast<double>(c.good_minutes));
       }});
  lines.push_back(
      {"GOOD under open sky, %", [](const Calibration& c) { return percent(c.open_good, c.open); }});
}

void add_detection(const std::string& what, Detection Calibration::*member, std::vector<Line>& lines) {
  lines.push_back({what + ": Brier score",
                   [member](const Calibration& c) { return shown((c.*member).brier.value(), 3); }});
  lines.push_back({what + ": told of after, until after its end (medians), s; not told of",
                   [member](const Calibration& c) {
                     const Detection& d = c.*member;
                     return median(d.told) + ", " + median(d.cleared) + "; " + std::to_string(d.missed) +
                            " of " + std::to_string(d.missed + d.told.size());
                   }});
}

const std::vector<Line>& lines() {
  static const std::vector<Line> all = [] {
    std::vector<Line> lines;
    add_ellipses(lines);
    lines.push_back({"NEES of position, open sky / shadow",
                     [](const Calibration& c) { return both(c.position_open, c.position_shadow); }});
    lines.push_back({"NEES of heading, open sky / shadow",
                     [](const Calibration& c) { return both(c.heading_open, c.heading_shadow); }});
    lines.push_back({"NIS of fixes; correlation with the next", [](const Calibration& c) {
                       return shown(c.nis.value(), 1) + "; " + shown(c.nis_next.value(), 2);
                     }});
    add_states(lines);
    add_detection("shadow", &Calibration::shadow, lines);
    add_detection("wheel fault", &Calibration::wheel_fault, lines);
    return lines;
  }();
  return all;
}

}  // namespace

std::string describe_calibration(const std::vector<RunRecord>& runs) {
  std::vector<std::string> names;
  for (const RunRecord& run : runs) {
    if (std::find(names.begin(), names.end(), run.estimator) == names.end()) names.push_back(run.estimator);
  }
  std::vector<TextColumn> columns = {{"how honest"}};
  for (const Line& line : lines()) columns.front().push_back(line.title);
  for (const std::string& name : names) {
    Calibration sum;
    for (const RunRecord& run : runs) {
      if (run.estimator == name) sum.add(run.calibration);
    }
    columns.push_back({name});
    for (const Line& line : lines()) columns.back().push_back(line.cell(sum));
  }
  return side_by_side(columns, 1);
}

}  // namespace multipath_localization
