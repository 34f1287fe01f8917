#include "evaluation/standings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "evaluation/random_suite.hpp"
#include "evaluation/text_table.hpp"

namespace multipath_localization {

namespace {

constexpr double kLeastError = 1e-3;    ///< [m]
constexpr double kBehind = 1.1;         ///< times the best other
constexpr double kOverconfident = 6.0;  ///< mean NEES
constexpr std::size_t kWorst = 10;      ///< drives that are named
const char* const kFixes = "(fixes as they are)";
const std::vector<std::string> kOthers = {kFixes, "gated_ekf", "two_stage_ekf"};

/// The runs over one drive by estimator.
struct Contest {
  std::map<std::string, const RunRecord*> runs;

  /// The error of an estimator, or of the fixes as they are [m]; nothing without a score.
  [[nodiscard]] std::optional<double> rmse(const std::string& estimator) const {
    for (const auto& [name, run] : runs) {
      if (!run->failure.empty() || (estimator != kFixes && estimator != name)) continue;
      const std::optional<double> rmse = estimator == kFixes ? run->fixes.rmse : run->score.rmse;
      if (rmse) return std::max(*rmse, kLeastError);
    }
    return std::nullopt;
  }

  /// The best of the others and its error [m].
  [[nodiscard]] std::optional<std::pair<std::string, double>> best_other(const std::string& than) const {
    std::optional<std::pair<std::string, double>> best;
    for (const std::string& other : kOthers) {
      const std::optional<double> error = other == than ? std::nullopt : rmse(other);
      if (error && (!best || *error < best->second)) best = {other, *error};
    }
    return best;
  }
};

using Drives = std::map<std::pair<std::string, std::uint64_t>, Contest>;

Drives by_drive(const std::vector<RunRecord>& runs, const std::string& kind) {
  Drives drives;
  for (const RunRecord& run : runs) {
    if (kind.empty() || run.kind == kind) drives[{run.source, run.seed}].runs[run.estimator] = &run;
  }
  return drives;
}

class GeometricMean {
 public:
  void add(double value) {
    sum_ += std::log(value);
    ++count_;
  }
  [[nodiscard]] std::optional<double> value() const {
    return count_ == 0 ? std::nullopt : std::optional(std::exp(sum_ / static_cast<double>(count_)));
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

/// Sums up one estimator, drive by drive.
class Tally {
 public:
  explicit Tally(const std::string& estimator) { standing_.estimator = estimator; }

  void add(const Contest& contest) {
    ++standing_.drives;
    const std::optional<double> rmse = contest.rmse(standing_.estimator);
    const auto best = contest.best_other(standing_.estimator);
    if (best) ++compared_;
    if (best && (!rmse || *rmse > kBehind * best->second)) ++behind_;
    if (const auto run = contest.runs.find(standing_.estimator); run != contest.runs.end())
      doubt(*run->second);
    if (!rmse) return;
    ++standing_.scored;
    rmse_.add(*rmse);
    if (best) to_best_.add(*rmse / best->second);
    if (const auto oracle = contest.rmse(kOracle)) to_oracle_.add(*rmse / *oracle);
  }

  [[nodiscard]] Standing standing() const {
    Standing standing = standing_;
    standing.rmse = rmse_.value();
    standing.to_best = to_best_.value();
    standing.to_oracle = to_oracle_.value();
    standing.behind = share(behind_, compared_);
    standing.overconfident = share(overconfident_, claims_);
    standing.beyond_5 = share(beyond_5_, claims_);
    standing.beyond_30 = share(beyond_30_, claims_);
    return standing;
  }

 private:
  static std::optional<double> share(std::size_t part, std::size_t all) {
    if (all == 0) return std::nullopt;
    return static_cast<double>(part) / static_cast<double>(all);
  }

  void doubt(const RunRecord& run) {
    ++claims_;
    standing_.cpu += run.cpu;
    const double beyond = run.longest_beyond_3_sigma.value_or(0.0);
    if (run.score.nees_mean.value_or(0.0) > kOverconfident) ++overconfident_;
    if (beyond > 5.0) ++beyond_5_;
    if (beyond > 30.0) ++beyond_30_;
  }

  Standing standing_;
  GeometricMean rmse_;
  GeometricMean to_best_;
  GeometricMean to_oracle_;
  std::size_t compared_ = 0;
  std::size_t behind_ = 0;
  std::size_t claims_ = 0;  ///< drives with a covariance of its own
  std::size_t overconfident_ = 0;
  std::size_t beyond_5_ = 0;
  std::size_t beyond_30_ = 0;
};

std::vector<std::string> estimators_of(const std::vector<RunRecord>& runs) {
  std::vector<std::string> names;
  for (const RunRecord& run : runs) {
    if (std::find(names.begin(), names.end(), run.estimator) == names.end()) names.push_back(run.estimator);
  }
  return names;
}

std::string shown(const std::optional<double>& value, double factor, int digits) {
  return value ? figure(*value * factor, digits) : "-";
}

std::vector<TextColumn> heading() {
  return {{"drives"},   {"estimator"},  {"scored"},         {"rmse m"},   {"to best other"}, {"to oracle"},
          {"behind %"}, {"NEES > 6 %"}, {"beyond > 5 s %"}, {"> 30 s %"}, {"cpu s"}};
}

void add_lines(const std::string& name, const std::vector<Standing>& lines,
               std::vector<TextColumn>& columns) {
  for (const Standing& line : lines) {
    const std::vector<std::string> cells = {name,
                                            line.estimator,
                                            std::to_string(line.scored) + "/" + std::to_string(line.drives),
                                            shown(line.rmse, 1.0, 2),
                                            shown(line.to_best, 1.0, 2),
                                            shown(line.to_oracle, 1.0, 2),
                                            shown(line.behind, 100.0, 0),
                                            shown(line.overconfident, 100.0, 0),
                                            shown(line.beyond_5, 100.0, 0),
                                            shown(line.beyond_30, 100.0, 0),
                                            figure(line.cpu, 1)};
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].push_back(cells[i]);
  }
}

std::string describe(const Comparison& worst) {
  const RunRecord& run = *worst.run;
  std::string text = run.source + " " + std::to_string(run.seed) + ": " + shown(run.score.rmse, 1.0, 2) +
                     " m, " + figure(worst.ratio, 2) + " times " + worst.best + "; NEES " +
                     shown(run.score.nees_mean, 1.0, 1) + ", outside 3 sigma for " +
                     shown(run.longest_beyond_3_sigma, 1.0, 0) + " s";
  if (!run.about.empty()) text += "; " + run.about;
  return text;
}

}  // namespace

std::vector<Standing> standings(const std::vector<RunRecord>& runs, const std::string& kind) {
  const Drives drives = by_drive(runs, kind);
  std::vector<std::string> names = estimators_of(runs);
  names.insert(names.begin(), kFixes);
  std::vector<Standing> all;
  for (const std::string& name : names) {
    Tally tally(name);
    for (const auto& [drive, contest] : drives) tally.add(contest);
    all.push_back(tally.standing());
  }
  return all;
}

std::vector<Comparison> worst_first(const std::vector<RunRecord>& runs) {
  std::vector<Comparison> all;
  for (const auto& [drive, contest] : by_drive(runs, "")) {
    const std::string& first = runs.front().estimator;
    const auto run = contest.runs.find(first);
    const auto best = contest.best_other(first);
    const std::optional<double> rmse = contest.rmse(first);
    if (run == contest.runs.end() || !best || !rmse) continue;
    all.push_back({run->second, best->first, best->second, *rmse / best->second});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Comparison& a, const Comparison& b) { return a.ratio > b.ratio; });
  return all;
}

std::string describe_standings(const std::vector<RunRecord>& runs) {
  std::vector<TextColumn> columns = heading();
  add_lines("all", standings(runs, ""), columns);
  std::set<std::string> kinds;
  for (const RunRecord& run : runs) kinds.insert(run.kind);
  for (const std::string& kind : kinds) {
    if (!kind.empty()) add_lines(kind, standings(runs, kind), columns);
  }
  std::string text = side_by_side(columns, 2) + "\nworst drives of " + runs.front().estimator + ":\n";
  const std::vector<Comparison> worst = worst_first(runs);
  for (std::size_t i = 0; i < std::min(kWorst, worst.size()); ++i) text += "  " + describe(worst[i]) + "\n";
  return text;
}

}  // namespace multipath_localization
