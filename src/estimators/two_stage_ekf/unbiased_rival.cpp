#include "estimators/two_stage_ekf/unbiased_rival.hpp"

namespace multipath_localization {

namespace {

using odometry_state::kSize;

/// A fix beside what a state expects of it.
struct Observation {
  Observation(const UnbiasedRival::State& state, const GnssFix& fix)
      : y(fix.position - odometry_state::pose(state.mean) * fix.antenna_in_base),
        H(odometry_state::antenna_jacobian(state.mean, fix.antenna_in_base)) {}

  [[nodiscard]] double log_likelihood(const UnbiasedRival::State& state, const Eigen::Matrix2d& R) const {
    return kalman::compare<kSize, 2>(state, y, H, R).log_likelihood;
  }

  Eigen::Vector2d y;
  Eigen::Matrix<double, 2, kSize> H;
};

}  // namespace

UnbiasedRival::UnbiasedRival(const State& state, const GnssFix& fix, const Eigen::Matrix2d& R,
                             double bias_sigma)
    : state_(state) {
  const Observation seen(state_, fix);
  const Eigen::Matrix2d R_biased = R + bias_sigma * bias_sigma * Eigen::Matrix2d::Identity();
  log_odds_ = seen.log_likelihood(state_, R) - seen.log_likelihood(state_, R_biased);
  // With |y|^2 more in position the fix is within one sigma, and does not pull at the heading.
  state_.covariance.topLeftCorner<2, 2>() += seen.y.squaredNorm() * Eigen::Matrix2d::Identity();
  kalman::correct<kSize, 2>(state_, seen.y, seen.H, R);
}

void UnbiasedRival::predict(const OdometryIncrement& u, const OdometryNoise& noise) {
  const odometry_state::Step step = odometry_state::step(state_.mean, u, noise);
  kalman::predict<kSize>(state_, step.mean, step.F, step.Q);
}

void UnbiasedRival::weigh(const GnssFix& fix, const Eigen::Matrix2d& R, double share,
                          double log_likelihood_with_bias) {
  const Observation seen(state_, fix);
  log_odds_ += share * (seen.log_likelihood(state_, R) - log_likelihood_with_bias);
  kalman::correct<kSize, 2>(state_, seen.y, seen.H, R / share);
}

}  // namespace multipath_localization
