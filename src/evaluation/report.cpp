#include "multipath_localization/evaluation/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <sstream>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

using Figure = std::function<std::optional<double>(const RunRecord&)>;

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    char escaped[8] = {c, '\0'};
    if (c == '"' || c == '\\') std::snprintf(escaped, sizeof escaped, "\\%c", c);
    if (static_cast<unsigned char>(c) < 0x20) std::snprintf(escaped, sizeof escaped, "\\u%04x", c);
    out += escaped;
  }
  return out + "\"";
}

std::string json(std::optional<double> value) {
  return value && std::isfinite(*value) ? number(*value, 6) : "null";
}

struct Column {
  std::string title;
  int digits;
  double unit;  ///< of the column in SI
  Figure figure;
};

/// A column of one member of the score.
Column of(const std::string& title, int digits, std::optional<double> Score::*member, double unit = 1.0) {
  return {title, digits, unit, [member](const RunRecord& record) { return record.score.*member; }};
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all = {
      {"epochs", 0, 1.0, [](const RunRecord& r) { return static_cast<double>(r.score.epochs); }},
      {"unscored", 0, 1.0, [](const RunRecord& r) { return static_cast<double>(r.score.unscored); }},
      of("mean", 2, &Score::mean),
      of("rmse", 2, &Score::rmse),
      of("median", 2, &Score::median),
      of("p95", 2, &Score::p95),
      of("max", 2, &Score::max),
      of("shadow", 2, &Score::rmse_shadow),
      of("open", 2, &Score::rmse_open),
      of("yaw deg", 2, &Score::heading_rmse, kPi / 180.0),
      of("NEES", 2, &Score::nees_mean),
      of("in 95 %", 0, &Score::in_ellipse, 0.01),
      {"cpu s", 2, 1.0, [](const RunRecord& r) { return r.cpu; }},
  };
  return all;
}

std::vector<double> figures(const std::vector<RunRecord>& runs, const Figure& figure) {
  std::vector<double> values;
  for (const RunRecord& run : runs) {
    if (const std::optional<double> value = figure(run)) values.push_back(*value);
  }
  return values;
}

std::string mean_cell(const std::vector<RunRecord>& runs, const Column& column) {
  const std::vector<double> values = figures(runs, column.figure);
  if (values.empty()) return "-";
  double sum = 0.0;
  for (const double value : values) sum += value;
  return number(sum / static_cast<double>(values.size()) / column.unit, column.digits);
}

std::string worst_cell(const std::vector<RunRecord>& runs) {
  const RunRecord* worst = nullptr;
  for (const RunRecord& run : runs) {
    if (run.score.rmse && (worst == nullptr || *run.score.rmse > *worst->score.rmse)) worst = &run;
  }
  if (worst == nullptr) return "-";
  return number(*worst->score.rmse, 2) + " (seed " + std::to_string(worst->seed) + ")";
}

std::vector<std::string> row(const std::vector<RunRecord>& runs) {
  std::vector<std::string> cells = {runs.front().estimator, std::to_string(runs.size())};
  for (const Column& column : columns()) cells.push_back(mean_cell(runs, column));
  cells.push_back(worst_cell(runs));
  return cells;
}

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& cells : rows) {
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  }
  std::string out;
  for (const auto& cells : rows) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(widths[i] - cells[i].size(), ' ');
      out += i == 0 ? cells[i] + padding : "  " + padding + cells[i];
    }
    out += "\n";
  }
  return out;
}

}  // namespace

std::string to_json(const std::vector<RunRecord>& records) {
  std::ostringstream out;
  out << "[";
  const char* separator = "\n";
  for (const RunRecord& record : records) {
    const Score& s = record.score;
    out << separator << "  {\"source\": " << quoted(record.source)
        << ", \"estimator\": " << quoted(record.estimator) << ", \"seed\": " << record.seed
        << ", \"epochs\": " << s.epochs << ", \"mean_m\": " << json(s.mean)
        << ", \"rmse_m\": " << json(s.rmse) << ", \"median_m\": " << json(s.median)
        << ", \"p95_m\": " << json(s.p95) << ", \"max_m\": " << json(s.max)
        << ", \"heading_rmse_rad\": " << json(s.heading_rmse)
        << ", \"rmse_shadow_m\": " << json(s.rmse_shadow) << ", \"rmse_open_m\": " << json(s.rmse_open)
        << ", \"nees_mean\": " << json(s.nees_mean) << ", \"cpu_s\": " << json(record.cpu) << "}";
    separator = ",\n";
  }
  out << "\n]\n";
  return out.str();
}

std::string to_table(const std::vector<RunRecord>& records) {
  std::vector<std::string> header = {"estimator", "runs"};
  for (const Column& column : columns()) header.push_back(column.title);
  header.emplace_back("worst rmse");
  std::vector<std::string> names;
  for (const RunRecord& record : records) {
    if (std::find(names.begin(), names.end(), record.estimator) == names.end())
      names.push_back(record.estimator);
  }
  std::vector<std::vector<std::string>> rows = {header};
  for (const std::string& name : names) {
    std::vector<RunRecord> runs;
    std::copy_if(records.begin(), records.end(), std::back_inserter(runs),
                 [&](const RunRecord& record) { return record.estimator == name; });
    rows.push_back(row(runs));
  }
  return aligned(rows);
}

}  // namespace multipath_localization
