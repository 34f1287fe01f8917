#pragma once

#include <Eigen/Core>

#include "estimators/ekf/odometry_state.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/filters/kalman.hpp"

namespace multipath_localization {

/// What there is if the fixes have had no bias from some moment of a fault on: a Kalman filter of odometry
/// and fixes as they are, and how likely the fixes were to it against the filter that estimates their bias.
/// It tells when a fault has ended, and where the robot then is.
class UnbiasedRival {
 public:
  using State = Gaussian<odometry_state::kSize>;

  /// The bias is gone with this fix: `state` is what the filter with bias holds of the robot, R (2x2) the
  /// fix's covariance, `bias_sigma` the standard deviation of a bias that would be there instead [m].
  UnbiasedRival(const State& state, const GnssFix& fix, const Eigen::Matrix2d& R, double bias_sigma);

  /// Carries on by a usable increment in which the wheels turned.
  void predict(const OdometryIncrement& u, const OdometryNoise& noise);

  /// Takes a fix that counts as `share`, in (0, 1], of an independent one.
  void weigh(const GnssFix& fix, const Eigen::Matrix2d& R, double share, double log_likelihood_with_bias);

  [[nodiscard]] double log_odds() const { return log_odds_; }  ///< of no bias against a bias
  [[nodiscard]] const State& state() const { return state_; }

 private:
  State state_;
  double log_odds_;
};

}  // namespace multipath_localization
