#include "evaluation/shortcomings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kFactor = 1.1;    ///< of the best RMSE that still counts as the best
constexpr double kMargin = 0.05;   ///< and above it [m]
constexpr double kPatience = 5.0;  ///< outside its own 3 sigma on end [s]

/// The runs of one estimator over one stream.
struct Row {
  std::string estimator;
  double sum = 0.0;  ///< of RMSE [m]
  std::size_t ended = 0;
  std::size_t failed = 0;
  double beyond = 0.0;  ///< longest outside 3 sigma [s]

  [[nodiscard]] double rmse() const {
    return ended == 0 ? std::numeric_limits<double>::infinity() : sum / static_cast<double>(ended);
  }
};

struct Contest {
  std::string name;
  std::vector<Row> rows;
};

template <class Entry, class Key>
Entry& entry(std::vector<Entry>& entries, Key Entry::*key, const Key& name) {
  const auto known =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.*key == name; });
  if (known != entries.end()) return *known;
  entries.emplace_back().*key = name;
  return entries.back();
}

std::vector<Contest> by_stream(const std::vector<RunRecord>& runs) {
  std::vector<Contest> contests;
  for (const RunRecord& run : runs) {
    Row& row = entry(entry(contests, &Contest::name, run.source).rows, &Row::estimator, run.estimator);
    if (!run.failure.empty() || !run.score.rmse) {
      ++row.failed;
      continue;
    }
    ++row.ended;
    row.sum += *run.score.rmse;
    row.beyond = std::max(row.beyond, run.longest_beyond_3_sigma.value_or(0.0));
  }
  return contests;
}

void judge(const Contest& contest, std::vector<std::string>& sentences) {
  const Row& own = contest.rows.front();
  const Row& best = *std::min_element(contest.rows.begin(), contest.rows.end(),
                                      [](const Row& a, const Row& b) { return a.rmse() < b.rmse(); });
  const auto say = [&](const auto&... parts) {
    PlainStream out;
    out.precision(2);
    out << std::fixed << contest.name << ": " << own.estimator << " ";
    (out << ... << parts);
    sentences.push_back(out.str());
  };
  if (own.failed > 0) say("gave nothing to score in ", own.failed, " of ", own.failed + own.ended, " runs");
  if (own.rmse() > std::max(kFactor * best.rmse(), best.rmse() + kMargin)) {
    say("has an RMSE of ", own.rmse(), " m, ", best.estimator, " of ", best.rmse(), " m");
  }
  if (own.beyond > kPatience) say("was outside its own 3 sigma for ", own.beyond, " s");
}

}  // namespace

std::vector<std::string> shortcomings(const std::vector<RunRecord>& runs) {
  std::vector<std::string> sentences;
  for (const Contest& contest : by_stream(runs)) judge(contest, sentences);
  return sentences;
}

}  // namespace multipath_localization
