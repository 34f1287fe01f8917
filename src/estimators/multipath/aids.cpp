#include "estimators/multipath/aids.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/filters/resampling.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kDoubtingShare = 0.2;      // of the hypotheses doubt an input when it comes,
constexpr std::size_t kMostDoubting = 640;  // ten for each heading
constexpr double kLeastDoubting = 0.05;     // of the hypotheses, once those that doubt agree on the heading

/// Variance of the heading within and between those that doubt an aid [rad^2].
double heading_variance_of_doubt(const std::vector<Hypothesis>& all, const Aids& aids) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double total = 0.0;
  double within = 0.0;
  for (const Hypothesis& h : all) {
    if (!aids.doubted(h)) continue;
    const double w = std::exp(h.log_weight);
    total += w;
    within += w * h.covariance(kYaw, kYaw);
    sum += w * Eigen::Vector2d(std::cos(h.mean(kYaw)), std::sin(h.mean(kYaw)));
  }
  return total > 0.0 ? within / total + 2.0 * (1.0 - std::min(1.0, sum.norm() / total)) : 0.0;
}

std::size_t part(double share, std::size_t count) {
  return static_cast<std::size_t>(share * static_cast<double>(count));
}

/// Appends `count` hypotheses drawn by weight of those that believe the aids, or that do not.
void append_drawn(const std::vector<Hypothesis>& from, const Aids& aids, bool believing, std::size_t count,
                  RandomStream& random, std::vector<Hypothesis>& to) {
  if (count == 0) return;
  std::vector<double> weights;
  weights.reserve(from.size());
  double share = 0.0;
  for (const Hypothesis& h : from) {
    weights.push_back(aids.doubted(h) != believing ? std::exp(h.log_weight) : 0.0);
    share += weights.back();
  }
  if (!(share > 0.0)) return;
  const double log_weight = std::log(share / static_cast<double>(count));
  for (const std::size_t i : systematic_resampling(weights, count, random.uniform())) {
    to.push_back(from[i]);
    to.back().log_weight = log_weight;
  }
}

/// How many hypotheses are to believe the aids, and how many are not.
struct Kinds {
  std::size_t believing = 0;
  std::size_t doubting = 0;
};

Kinds kinds_of(const std::vector<Hypothesis>& hypotheses, const Aids& aids, bool settled, std::size_t count) {
  std::size_t doubting = 0;
  double share = 0.0;
  for (const Hypothesis& h : hypotheses) {
    if (!aids.doubted(h)) continue;
    ++doubting;
    share += std::exp(h.log_weight);
  }
  if (doubting == hypotheses.size()) return {0, count};
  if (!(share > 0.0)) return {count, 0};
  const bool agreed = heading_variance_of_doubt(hypotheses, aids) < kAgreedVariance;
  const std::size_t by_weight = std::min(count - 1, part(share, count));
  const std::size_t least = agreed ? part(kLeastDoubting, count) : std::min(doubting, kMostDoubting);
  const std::size_t doubters = std::min(count - 1, std::max(by_weight, least));
  // Those that do not know the heading yet come on top of the others that do.
  return {count - (settled && !agreed ? by_weight : doubters), doubters};
}

}  // namespace

bool draw_belief(Hypothesis& h, double doubted, RandomStream& random) {
  const bool believed = random.uniform() >= kDoubtingShare;
  h.log_weight += std::log(believed ? (1.0 - doubted) / (1.0 - kDoubtingShare) : doubted / kDoubtingShare);
  return believed;
}

void weigh_believing(std::vector<Hypothesis>& hypotheses,
                     const std::vector<std::optional<double>>& log_density, bool heading_known,
                     bool (*is_outlier)(const Hypothesis&)) {
  double highest = std::numeric_limits<double>::lowest();
  for (const std::optional<double>& log : log_density) highest = std::max(highest, log.value_or(highest));
  double before = 0.0;
  double after = 0.0;
  double reflected = 0.0;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (!log_density[i]) continue;
    const double w = std::exp(hypotheses[i].log_weight);
    before += w;
    reflected += is_outlier(hypotheses[i]) ? w : 0.0;
    after += w * std::exp(*log_density[i] - highest);
  }
  // What most take for a reflection is no evidence for those few that have lost the heading and agree.
  if (!(after > 0.0) || (heading_known && reflected > 0.5 * before)) return;
  const double expected = highest + std::log(after / before);
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (log_density[i]) hypotheses[i].log_weight += *log_density[i] - expected;
  }
}

std::vector<Hypothesis> drawn_by_kind(const std::vector<Hypothesis>& hypotheses, const Aids& aids,
                                      bool settled, std::size_t count, RandomStream& random) {
  const Kinds wanted = kinds_of(hypotheses, aids, settled, count);
  std::vector<Hypothesis> chosen;
  chosen.reserve(wanted.believing + wanted.doubting);
  append_drawn(hypotheses, aids, true, wanted.believing, random, chosen);
  append_drawn(hypotheses, aids, false, wanted.doubting, random, chosen);
  return chosen;
}

}  // namespace multipath_localization::multipath
