#include "multipath_localization/localization/receiver_covariance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kFewest = 5;           ///< deviations that tell something
constexpr double kStanding = 0.02;           ///< way between fixes of a robot that stands [m]
const double kMedian = 2.0 * std::log(2.0);  ///< of the squared length of a standard normal 2-vector

}  // namespace

void ReceiverCovarianceParameters::fields(ParameterVisitor& field) {
  field("source", source, {"message", "fixed", "adaptive"},
        "what counts for estimators that go by a covariance: the one declared, `fixed_sigma`, or the one "
        "declared but no less than fixes are seen to be off; within the estimator's fix_sigma_floor and "
        "fix_sigma_cap");
  field("scale", scale, {0.01, 100.0}, "1", "declared standard deviations count times this");
  field("fixed_sigma", fixed_sigma, {1e-3, 1e3}, "m", "of every fix where `source` is fixed");
  field("window", window, {1.0, 1e4}, "m", "over which fixes are seen to be off");
}

void ReceiverCovariance::observe(double driven, const Eigen::Vector2d& deviation) {
  if (!deviations_.empty() && driven - deviations_.back().driven < kStanding) return;
  deviations_.push_back({driven, deviation.squaredNorm()});
  while (deviations_.size() > kFewest && deviations_.front().driven < driven - parameters_.window) {
    deviations_.pop_front();
  }
}

std::optional<double> ReceiverCovariance::observed_sigma() const {
  if (deviations_.size() < kFewest) return std::nullopt;
  std::vector<double> squares;
  squares.reserve(deviations_.size());
  for (const Deviation& deviation : deviations_) squares.push_back(deviation.squared);
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return std::sqrt(*middle / kMedian);
}

Eigen::Matrix2d ReceiverCovariance::of(const Eigen::Matrix2d& declared) const {
  if (parameters_.source == CovarianceSource::kFixed)
    return square(parameters_.fixed_sigma) * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d scaled = square(parameters_.scale) * declared;
  const double variance = 0.5 * scaled.trace();
  const double observed =
      parameters_.source == CovarianceSource::kAdaptive ? square(observed_sigma().value_or(0.0)) : 0.0;
  if (observed <= variance) return scaled;
  return variance > 0.0 ? Eigen::Matrix2d(observed / variance * scaled)
                        : Eigen::Matrix2d(observed * Eigen::Matrix2d::Identity());
}

}  // namespace multipath_localization
