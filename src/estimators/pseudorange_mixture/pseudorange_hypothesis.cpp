#include "estimators/pseudorange_mixture/pseudorange_hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kLeastProbability = 1e-6;  // of a law: no way without return
constexpr double kRangeTime = 5.0;          // ranges of this duration count once in weighing laws [s]
constexpr double kLeastShare = 1e-3;        // of a filter worth mixing in

using Shares = std::array<double, kMotionLaws>;

std::size_t largest(const Shares& shares) {
  return static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
}

/// The filters as one, by their shares, which sum to one.
PseudorangeKalmanFilter mixture(const std::array<PseudorangeKalmanFilter, kMotionLaws>& filters,
                                const Shares& shares) {
  const std::size_t first = largest(shares);
  PseudorangeKalmanFilter result = filters[first];
  double total = shares[first];
  for (std::size_t i = 0; i < kMotionLaws; ++i) {
    if (i == first || shares[i] < kLeastShare) continue;
    total += shares[i];
    result.mix(filters[i], shares[i] / total);
  }
  return result;
}

/// exp of each, scaled to the sum 1.
Shares normalised(const Shares& logs) {
  const double highest = *std::max_element(logs.begin(), logs.end());
  Shares result{};
  double sum = 0.0;
  for (std::size_t i = 0; i < kMotionLaws; ++i) sum += result[i] = std::exp(logs[i] - highest);
  for (double& share : result) share = std::max(share / sum, kLeastProbability);
  return result;
}

/// What it costs a hypothesis that its robot has to move by a law it did not believe in: log of the
/// likelihood of the epoch over that under the best law. A wrong heading needs wheels that fail.
double surprise(const Shares& logs, const Shares& before) {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kMotionLaws; ++i) best = std::max(best, logs[i] - std::log(before[i]));
  double sum = 0.0;
  for (const double log : logs) sum += std::exp(log - best);
  return std::log(sum);
}

}  // namespace

PseudorangeHypothesis::PseudorangeHypothesis(const PseudorangeBelief& belief, const MotionLaws& laws)
    : filters_{PseudorangeKalmanFilter(belief), PseudorangeKalmanFilter(belief),
               PseudorangeKalmanFilter(belief), PseudorangeKalmanFilter(belief)},
      probabilities_(laws.starting) {}

void PseudorangeHypothesis::learn_from(const PseudorangeHypothesis& other) {
  probabilities_ = other.probabilities_;
  for (std::size_t i = 0; i < kMotionLaws; ++i) filters_[i].scales = other.filters_[i].scales;
}

std::size_t PseudorangeHypothesis::best() const { return largest(probabilities_); }

void PseudorangeHypothesis::append(double variance) {
  for (PseudorangeKalmanFilter& filter : filters_) filter.append(variance);
}

void PseudorangeHypothesis::remove(int slot) {
  for (PseudorangeKalmanFilter& filter : filters_) filter.remove(slot);
}

void PseudorangeHypothesis::propagate(const PreintegratedOdometry& odometry, const MotionLaws& laws,
                                      const OdometryNoise& odometry_noise, const ReceiverStateNoise& noise,
                                      const SatelliteSlots& slots) {
  for (std::size_t i = 0; i < kMotionLaws; ++i) {
    filters_[i].propagate(odometry, laws.laws[i], odometry_noise, noise, slots);
  }
}

void PseudorangeHypothesis::interact(const MotionLaws::Matrix& transitions) {
  const auto before = filters_;
  const Shares were = probabilities_;
  for (std::size_t j = 0; j < kMotionLaws; ++j) {
    Shares shares{};
    double sum = 0.0;
    for (std::size_t i = 0; i < kMotionLaws; ++i) sum += shares[i] = transitions[i][j] * were[i];
    for (double& share : shares) share /= sum;
    filters_[j] = mixture(before, shares);
    probabilities_[j] = sum;
  }
}

void PseudorangeHypothesis::update(const SlottedEpoch& epoch, const MotionLaws& laws,
                                   const RangeErrorParameters& errors) {
  interact(laws.transitions(epoch.duration));
  const double of_rates = std::min(1.0, epoch.duration / kRangeRateTime);
  const double of_ranges = std::min(1.0, epoch.duration / kRangeTime);
  Shares place{};
  Shares logs{};
  for (std::size_t i = 0; i < kMotionLaws; ++i) {
    const EpochEvidence evidence = filters_[i].update(epoch, errors);
    place[i] = evidence.place;
    logs[i] = std::log(probabilities_[i]) + of_rates * evidence.rates + of_ranges * evidence.ranges;
  }
  if (epoch.wheels) log_weight += surprise(logs, probabilities_);
  probabilities_ = normalised(logs);
  double sum = 0.0;
  for (std::size_t i = 0; i < kMotionLaws; ++i) sum += probabilities_[i] * std::exp(place[i] - place[0]);
  log_weight += place[0] + std::log(sum);
}

Belief PseudorangeHypothesis::planar() const {
  const std::size_t first = best();
  Belief result = filters_[first].belief.planar();
  double total = probabilities_[first];
  for (std::size_t i = 0; i < kMotionLaws; ++i) {
    if (i == first || probabilities_[i] < kLeastShare) continue;
    const Belief other = filters_[i].belief.planar();
    total += probabilities_[i];
    merge(result.mean, result.covariance, other.mean, other.covariance, probabilities_[i] / total);
  }
  return result;
}

double PseudorangeHypothesis::line_of_sight_share() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < kMotionLaws; ++i) sum += probabilities_[i] * filters_[i].line_of_sight_share;
  return sum;
}

}  // namespace multipath_localization
