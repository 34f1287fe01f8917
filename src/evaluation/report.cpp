#include "multipath_localization/evaluation/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>
#include <sstream>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, value);
  return text;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    char escaped[8] = {c, '\0'};
    if (c == '"' || c == '\\') std::snprintf(escaped, sizeof(escaped), "\\%c", c);
    if (static_cast<unsigned char>(c) < 0x20) std::snprintf(escaped, sizeof(escaped), "\\u%04x", c);
    out += escaped;
  }
  return out + "\"";
}

std::string json(std::optional<double> value) {
  return value && std::isfinite(*value) ? number(*value, 6) : "null";
}

/// A line of the table: the runs behind it and which score of theirs it is about.
struct Line {
  std::string title;
  std::vector<const Run*> runs;
  Score Run::*score;
};

using Figure = std::function<std::optional<double>(const Run&, const Score&)>;

struct Column {
  std::string title;
  int digits;
  Figure figure;
  bool of_fixes;  ///< applies to the fixes too
};

Column of(const std::string& title, std::optional<double> Score::*member) {
  return {title, 2, [member](const Run&, const Score& score) { return score.*member; }, true};
}

std::optional<double> scaled(std::optional<double> value, double factor) {
  return value ? std::optional(*value * factor) : std::nullopt;
}

/// A count, where there is anything to count.
std::optional<double> count(std::size_t value) {
  return value == 0 ? std::nullopt : std::optional(static_cast<double>(value));
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all = {
      {"epochs", 0, [](const Run&, const Score& s) { return count(s.epochs); }, true},
      {"without", 0, [](const Run&, const Score& s) { return count(s.unscored); }, true},
      of("mean m", &Score::mean),
      of("rmse", &Score::rmse),
      of("median", &Score::median),
      of("95 %", &Score::p95),
      of("max", &Score::max),
      of("shadow", &Score::rmse_shadow),
      of("open", &Score::rmse_open),
      {"yaw deg", 2, [](const Run&, const Score& s) { return scaled(s.heading_rmse, 180.0 / kPi); }, true},
      of("NEES", &Score::nees_mean),
      {"in 95 %", 0, [](const Run&, const Score& s) { return scaled(s.in_ellipse, 100.0); }, true},
      {"waypoints", 1, [](const Run& run, const Score&) { return count(run.course.waypoints_passed); },
       false},
      {"miss m", 2, [](const Run& run, const Score&) { return run.course.worst_miss; }, false},
      {"cpu s", 2, [](const Run& run, const Score&) { return std::optional(run.cpu); }, false},
  };
  return all;
}

std::string mean_cell(const Line& line, const Column& column) {
  if (line.score == &Run::fixes && !column.of_fixes) return "-";
  std::vector<double> values;
  for (const Run* run : line.runs) {
    if (const std::optional<double> value = column.figure(*run, run->*line.score)) values.push_back(*value);
  }
  if (values.empty()) return "-";
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return number(sum / static_cast<double>(values.size()), column.digits);
}

std::string worst_cell(const Line& line) {
  const Run* worst = nullptr;
  for (const Run* run : line.runs) {
    const std::optional<double> rmse = (run->*line.score).rmse;
    if (rmse && (worst == nullptr || *rmse > *(worst->*line.score).rmse)) worst = run;
  }
  if (worst == nullptr) return "-";
  return number(*(worst->*line.score).rmse, 2) + " (" + std::to_string(worst->seed) + ")";
}

std::vector<Line> lines(const std::vector<Run>& runs) {
  std::vector<Line> all = {{"(fixes as they are)", {}, &Run::fixes}};
  for (const Run& run : runs) {
    if (!run.failure.empty()) continue;
    const auto known =
        std::find_if(all.begin() + 1, all.end(), [&](const Line& l) { return l.title == run.estimator; });
    if (known == all.end()) {
      all.push_back({run.estimator, {&run}, &Run::score});
    } else {
      known->runs.push_back(&run);
    }
  }
  if (all.size() > 1) all.front().runs = all[1].runs;
  return all;
}

using TextColumn = std::vector<std::string>;

std::string side_by_side(const std::vector<TextColumn>& text) {
  std::string out;
  for (std::size_t row = 0; row < text.front().size(); ++row) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      std::size_t width = 0;
      for (const std::string& cell : text[i]) width = std::max(width, cell.size());
      const std::string padding(width - text[i][row].size(), ' ');
      out += i == 0 ? text[i][row] + padding : "  " + padding + text[i][row];
    }
    out += "\n";
  }
  return out;
}

}  // namespace

std::string to_json(const std::vector<Run>& runs) {
  std::ostringstream out;
  out << "[";
  const char* separator = "\n";
  for (const Run& run : runs) {
    if (!run.failure.empty()) continue;
    const Score& s = run.score;
    out << separator << "  {\"source\": " << quoted(run.source)
        << ", \"estimator\": " << quoted(run.estimator) << ", \"seed\": " << run.seed
        << ", \"epochs\": " << s.epochs << ", \"mean_m\": " << json(s.mean)
        << ", \"rmse_m\": " << json(s.rmse) << ", \"median_m\": " << json(s.median)
        << ", \"p95_m\": " << json(s.p95) << ", \"max_m\": " << json(s.max)
        << ", \"heading_rmse_rad\": " << json(s.heading_rmse)
        << ", \"rmse_shadow_m\": " << json(s.rmse_shadow) << ", \"rmse_open_m\": " << json(s.rmse_open)
        << ", \"nees_mean\": " << json(s.nees_mean) << ", \"cpu_s\": " << json(run.cpu) << "}";
    separator = ",\n";
  }
  out << "\n]\n";
  return out.str();
}

std::string to_table(const std::vector<Run>& runs) {
  const std::vector<Line> rows = lines(runs);
  std::vector<TextColumn> text = {{"estimator"}, {"runs"}};
  for (const Line& line : rows) {
    text[0].push_back(line.title);
    text[1].push_back(std::to_string(line.runs.size()));
  }
  for (const Column& column : columns()) {
    TextColumn cells = {column.title};
    for (const Line& line : rows) cells.push_back(mean_cell(line, column));
    if (std::any_of(cells.begin() + 1, cells.end(), [](const std::string& cell) { return cell != "-"; })) {
      text.push_back(cells);
    }
  }
  TextColumn worst = {"worst rmse (seed)"};
  for (const Line& line : rows) worst.push_back(worst_cell(line));
  text.push_back(worst);
  return side_by_side(text);
}

}  // namespace multipath_localization
