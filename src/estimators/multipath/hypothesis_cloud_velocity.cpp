#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "estimators/multipath/hypothesis_cloud.hpp"
#include "estimators/multipath/velocity_explanations.hpp"
#include "multipath_localization/filters/resampling.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr std::uint64_t kVelocitySeed = 0xD1B54A32D192ED03U;  // draws that fixes alone do not take
constexpr std::uint32_t kResampling = 0xFFFFFFFEU;            // a stream beside those of the hypotheses
constexpr double kEvidenceTime = 2.0;                         // velocities are off alike for about that [s]
constexpr double kDoubted = 0.003;          // of receivers' velocities are of another frame or sign
constexpr double kDoubtingShare = 0.2;      // of the hypotheses hold that, so that they know all headings
constexpr std::size_t kMostDoubting = 640;  // ten for each heading
constexpr double kLeastDoubting = 0.05;     // of the hypotheses, once those that doubt agree on the heading
constexpr double kAgreedVariance = 0.1;     // of headings that do [rad^2]

/// Variance of the heading within and between those that doubt the velocities [rad^2].
double heading_variance_of_doubt(const std::vector<Hypothesis>& all) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double total = 0.0;
  double within = 0.0;
  for (const Hypothesis& h : all) {
    if (h.velocity.believed) continue;
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

/// Weighs those that believe among themselves by their logarithms of the density, equation (21).
void weigh_believing(std::vector<Hypothesis>& hypotheses,
                     const std::vector<std::optional<double>>& log_density, bool heading_known) {
  double highest = std::numeric_limits<double>::lowest();
  for (const std::optional<double>& log : log_density) highest = std::max(highest, log.value_or(highest));
  double before = 0.0;
  double after = 0.0;
  double reflected = 0.0;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (!log_density[i]) continue;
    const double w = std::exp(hypotheses[i].log_weight);
    before += w;
    reflected += hypotheses[i].velocity.outlier ? w : 0.0;
    after += w * std::exp(*log_density[i] - highest);
  }
  // What most take for a reflection is no evidence for those few that have lost the heading and agree.
  if (!(after > 0.0) || (heading_known && reflected > 0.5 * before)) return;
  const double expected = highest + std::log(after / before);
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (log_density[i]) hypotheses[i].log_weight += *log_density[i] - expected;
  }
}

/// Appends `count` hypotheses drawn by weight of those that believe velocities, or that do not.
void append_drawn(const std::vector<Hypothesis>& from, bool believing, std::size_t count,
                  RandomStream& random, std::vector<Hypothesis>& to) {
  if (count == 0) return;
  std::vector<double> weights;
  weights.reserve(from.size());
  double share = 0.0;
  for (const Hypothesis& h : from) {
    weights.push_back(h.velocity.believed == believing ? std::exp(h.log_weight) : 0.0);
    share += weights.back();
  }
  if (!(share > 0.0)) return;
  const double log_weight = std::log(share / static_cast<double>(count));
  for (const std::size_t i : systematic_resampling(weights, count, random.uniform())) {
    to.push_back(from[i]);
    to.back().log_weight = log_weight;
  }
}

/// Draws laws of velocities for the hypotheses that have none.
void draw_velocity_laws(std::vector<Hypothesis>& hypotheses, bool near_start, std::uint64_t seed,
                        std::uint32_t step) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    Hypothesis& h = hypotheses[i];
    if (h.velocity.drawn) continue;
    RandomStream random(seed ^ kVelocitySeed, step, static_cast<std::uint32_t>(i));
    h.velocity.drawn = true;
    draw_velocity_errors(h.velocity, random);
    h.velocity.believed = random.uniform() >= kDoubtingShare;
    h.velocity.seeks_course = h.velocity.seeks_course && near_start;
    h.velocity.way_noise.setZero();
    h.log_weight +=
        std::log(h.velocity.believed ? (1.0 - kDoubted) / (1.0 - kDoubtingShare) : kDoubted / kDoubtingShare);
  }
}

/// How many hypotheses are to believe the velocities, and how many are not.
struct Kinds {
  std::size_t believing = 0;
  std::size_t doubting = 0;
};

Kinds kinds_of(const std::vector<Hypothesis>& hypotheses, bool settled, std::size_t count) {
  std::size_t doubting = 0;
  double share = 0.0;
  for (const Hypothesis& h : hypotheses) {
    if (h.velocity.believed) continue;
    ++doubting;
    share += std::exp(h.log_weight);
  }
  if (doubting == hypotheses.size()) return {0, count};
  if (!(share > 0.0)) return {count, 0};
  const bool agreed = heading_variance_of_doubt(hypotheses) < kAgreedVariance;
  const std::size_t by_weight = std::min(count - 1, part(share, count));
  const std::size_t least = agreed ? part(kLeastDoubting, count) : std::min(doubting, kMostDoubting);
  const std::size_t doubters = std::min(count - 1, std::max(by_weight, least));
  // Those that do not know the heading yet come on top of the others that do.
  return {count - (settled && !agreed ? by_weight : doubters), doubters};
}

}  // namespace

void HypothesisCloud::weigh(const VelocitySighting& sighting) {
  draw_velocity_laws(hypotheses_, sighting.near_start, seed_, ++velocity_step_);
  ++velocity_step_;
  const double share = std::min(1.0, sighting.duration / kEvidenceTime);
  std::vector<std::optional<double>> log_density(hypotheses_.size());
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    RandomStream random(seed_ ^ kVelocitySeed, velocity_step_, static_cast<std::uint32_t>(i));
    Hypothesis& h = hypotheses_[i];
    wander(h.velocity, sighting.duration, random);
    if (h.velocity.believed) log_density[i] = explain_velocity(h, sighting, random);
    if (log_density[i]) *log_density[i] *= share;
    h.velocity.way_noise.setZero();
  }
  weigh_believing(hypotheses_, log_density, mixture_.covariance(2, 2) < kAgreedVariance);
  refresh();
  resample();
}

void HypothesisCloud::resample_by_kind(std::size_t count) {
  const bool settled = mixture_.covariance(2, 2) < kAgreedVariance;
  const Kinds wanted = kinds_of(hypotheses_, settled, count);
  RandomStream random(seed_ ^ kVelocitySeed, velocity_step_ + step_, kResampling);
  std::vector<Hypothesis> chosen;
  chosen.reserve(wanted.believing + wanted.doubting);
  append_drawn(hypotheses_, true, wanted.believing, random, chosen);
  append_drawn(hypotheses_, false, wanted.doubting, random, chosen);
  hypotheses_ = std::move(chosen);
  refresh();
}

}  // namespace multipath_localization::multipath
