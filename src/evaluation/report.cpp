#include "evaluation/report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "evaluation/json.hpp"
#include "evaluation/text_table.hpp"
#include "multipath_localization/core/angle.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

std::string json(std::optional<double> value) {
  return value && std::isfinite(*value) ? number(*value, 6) : "null";
}

/// A line of the table: the runs behind it and which score of theirs it is about.
struct Line {
  std::string source;
  std::string title;
  std::vector<const RunRecord*> runs;
  Score RunRecord::*score;
};

using Figure = std::function<std::optional<double>(const RunRecord&, const Score&)>;

/// What a line says of its runs.
enum class Over { kMean, kLeast, kMost };

struct Column {
  std::string title;
  int digits;
  Figure figure;
  Over over = Over::kMean;
  bool of_fixes = true;  ///< applies to the fixes too
};

double combined(const std::vector<double>& values, Over over) {
  if (over == Over::kLeast) return *std::min_element(values.begin(), values.end());
  if (over == Over::kMost) return *std::max_element(values.begin(), values.end());
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Column of(const std::string& title, std::optional<double> Score::*member) {
  return {title, 2, [member](const RunRecord&, const Score& score) { return score.*member; }};
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
      {"epochs", 0, [](const RunRecord&, const Score& s) { return count(s.epochs); }},
      {"without", 0, [](const RunRecord&, const Score& s) { return count(s.unscored); }},
      of("mean m", &Score::mean),
      of("rmse", &Score::rmse),
      of("median", &Score::median),
      of("95 %", &Score::p95),
      of("max", &Score::max),
      of("shadow", &Score::rmse_shadow),
      of("open", &Score::rmse_open),
      {"yaw deg", 2, [](const RunRecord&, const Score& s) { return scaled(s.heading_rmse, 180.0 / kPi); }},
      of("NEES", &Score::nees_mean),
      {"in 95 %", 0, [](const RunRecord&, const Score& s) { return scaled(s.in_ellipse, 100.0); }},
      {"off s <=", 1, [](const RunRecord& run, const Score&) { return run.longest_off; }, Over::kMost, false},
      {"beyond 3 sigma s <=", 1,
       [](const RunRecord& run, const Score&) { return run.longest_beyond_3_sigma; }, Over::kMost, false},
      {"waypoints >=", 0,
       [](const RunRecord& run, const Score&) { return count(run.course.waypoints_passed); }, Over::kLeast,
       false},
      {"missed by <=", 2, [](const RunRecord& run, const Score&) { return run.course.worst_miss; },
       Over::kMost, false},
      {"cpu s", 2, [](const RunRecord& run, const Score&) { return std::optional(run.cpu); }, Over::kMean,
       false},
  };
  return all;
}

std::string cell_of(const Line& line, const Column& column) {
  if (line.score == &RunRecord::fixes && !column.of_fixes) return "-";
  std::vector<double> values;
  for (const RunRecord* run : line.runs) {
    if (const std::optional<double> value = column.figure(*run, run->*line.score)) values.push_back(*value);
  }
  if (values.empty()) return "-";
  return figure(combined(values, column.over), column.digits);
}

std::string worst_cell(const Line& line) {
  const RunRecord* worst = nullptr;
  for (const RunRecord* run : line.runs) {
    const std::optional<double> rmse = (run->*line.score).rmse;
    if (rmse && (worst == nullptr || *rmse > *(worst->*line.score).rmse)) worst = run;
  }
  if (worst == nullptr) return "-";
  return figure(*(worst->*line.score).rmse, 2) + " (" + std::to_string(worst->seed) + ")";
}

/// One line per source for the fixes as they are, then one per estimator.
std::vector<Line> lines(const std::vector<RunRecord>& runs) {
  std::vector<Line> all;
  const auto line = [&](const std::string& source, const std::string& title,
                        Score RunRecord::*score) -> Line& {
    const auto known = std::find_if(all.begin(), all.end(), [&](const Line& l) {
      return l.source == source && l.title == title && l.score == score;
    });
    return known == all.end() ? all.emplace_back(Line{source, title, {}, score}) : *known;
  };
  const RunRecord* first = nullptr;
  for (const RunRecord& run : runs) {
    if (!run.failure.empty()) continue;
    if (first == nullptr || run.source != first->source) first = &run;
    if (run.estimator == first->estimator) {
      line(run.source, "(fixes as they are)", &RunRecord::fixes).runs.push_back(&run);
    }
    line(run.source, run.estimator, &RunRecord::score).runs.push_back(&run);
  }
  return all;
}

/// What is told of the drive, each with a comma before it.
std::string json_of_drive(const RunRecord& run) {
  std::string out;
  if (!run.kind.empty()) out += ", \"kind\": " + quoted(run.kind);
  if (!run.about.empty()) out += ", \"about\": " + quoted(run.about);
  for (const auto& [name, value] : run.traits) out += ", " + quoted(name) + ": " + value;
  return out;
}

}  // namespace

std::string json_of_figures(const RunRecord& run) {
  const Score& s = run.score;
  PlainStream out;
  out << "{\"source\": " << quoted(run.source) << ", \"estimator\": " << quoted(run.estimator)
      << ", \"seed\": " << run.seed << ", \"epochs\": " << s.epochs << ", \"mean_m\": " << json(s.mean)
      << ", \"rmse_m\": " << json(s.rmse) << ", \"median_m\": " << json(s.median)
      << ", \"p95_m\": " << json(s.p95) << ", \"max_m\": " << json(s.max)
      << ", \"heading_rmse_rad\": " << json(s.heading_rmse) << ", \"rmse_shadow_m\": " << json(s.rmse_shadow)
      << ", \"rmse_open_m\": " << json(s.rmse_open) << ", \"longest_off_s\": " << json(run.longest_off)
      << ", \"longest_beyond_3_sigma_s\": " << json(run.longest_beyond_3_sigma)
      << ", \"way_to_alignment_m\": " << json(run.way_to_alignment)
      << ", \"nees_mean\": " << json(s.nees_mean) << ", \"cpu_s\": " << json(run.cpu)
      << ", \"fix_rmse_m\": " << json(run.fixes.rmse) << ", \"fix_median_m\": " << json(run.fixes.median)
      << ", \"fix_p95_m\": " << json(run.fixes.p95) << ", \"fix_max_m\": " << json(run.fixes.max)
      << ", \"fix_rmse_shadow_m\": " << json(run.fixes.rmse_shadow)
      << ", \"fix_rmse_open_m\": " << json(run.fixes.rmse_open) << json_of_drive(run) << "}";
  return out.str();
}

std::string to_json(const std::vector<RunRecord>& runs) {
  std::string out = "[";
  const char* separator = "\n  ";
  for (const RunRecord& run : runs) {
    if (!run.failure.empty()) continue;
    out += separator + json_of_figures(run);
    separator = ",\n  ";
  }
  return out + "\n]\n";
}

std::string to_table(const std::vector<RunRecord>& runs) {
  const std::vector<Line> rows = lines(runs);
  const bool several = std::any_of(rows.begin(), rows.end(),
                                   [&](const Line& line) { return line.source != rows.front().source; });
  TextColumn sources = {"stream"};
  TextColumn estimators = {"estimator"};
  TextColumn counts = {"runs"};
  for (const Line& line : rows) {
    sources.push_back(line.source);
    estimators.push_back(line.title);
    counts.push_back(std::to_string(line.runs.size()));
  }
  std::vector<TextColumn> text = {estimators, counts};
  if (several) text.insert(text.begin(), sources);
  for (const Column& column : columns()) {
    TextColumn cells = {column.title};
    for (const Line& line : rows) cells.push_back(cell_of(line, column));
    if (std::any_of(cells.begin() + 1, cells.end(), [](const std::string& cell) { return cell != "-"; })) {
      text.push_back(cells);
    }
  }
  TextColumn worst = {"worst rmse (seed)"};
  for (const Line& line : rows) worst.push_back(worst_cell(line));
  text.push_back(worst);
  return side_by_side(text, several ? 2 : 1);
}

std::string losses(const std::vector<RunRecord>& runs) {
  constexpr std::array<const char*, std::variant_size_v<Measurement>> kKinds = {
      "fixes", "pairs of fixes", "epochs", "velocities", "headings"};
  std::string text;
  for (const RunRecord& run : runs) {
    for (std::size_t kind = 0; run.seed == 1 && kind < kKinds.size(); ++kind) {
      if (!run.fates[kind].falls_short()) continue;
      text += run.estimator + ": " + kKinds[kind] + ": " + run.fates[kind].explained_sum() + "\n";
    }
  }
  return text;
}

}  // namespace multipath_localization
