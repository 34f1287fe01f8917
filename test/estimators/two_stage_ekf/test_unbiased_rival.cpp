#include <gtest/gtest.h>

#include <cmath>

#include "estimators/two_stage_ekf/unbiased_rival.hpp"

namespace multipath_localization {
namespace {

constexpr double kBiasSigma = 5.0;

const Eigen::Matrix2d kR = 0.25 * Eigen::Matrix2d::Identity();

UnbiasedRival::State settled() {
  UnbiasedRival::State state;
  state.mean << 3.0, -2.0, 0.5, 0.01, 0.001;
  state.covariance = odometry_state::unknown_covariance(OdometryNoise{});
  state.covariance.topLeftCorner<3, 3>() = Eigen::Vector3d(0.15, 0.15, 0.01).asDiagonal();
  state.covariance(1, 2) = state.covariance(2, 1) = 0.02;
  return state;
}

GnssFix fix_at(double x, double y) {
  GnssFix fix;
  fix.position = {x, y};
  fix.covariance = kR;
  return fix;
}

TEST(UnbiasedRival, OddsAreThoseOfNoBiasAgainstTheOneThatWouldBeThere) {
  const double with = 0.15 + 0.25 + kBiasSigma * kBiasSigma;
  const double without = 0.15 + 0.25;
  EXPECT_NEAR(UnbiasedRival(settled(), fix_at(3.0, -2.0), kR, kBiasSigma).log_odds(),
              std::log(with / without), 1e-12);
  EXPECT_NEAR(UnbiasedRival(settled(), fix_at(6.0, -2.0), kR, kBiasSigma).log_odds(),
              std::log(with / without) - 0.5 * 9.0 * (1.0 / without - 1.0 / with), 1e-12);
}

TEST(UnbiasedRival, GoesWhereTheFixIsAndKeepsItsHeading) {
  const UnbiasedRival rival(settled(), fix_at(3.0, 8.0), kR, kBiasSigma);
  EXPECT_NEAR(rival.state().mean(1), 8.0, 0.3);
  EXPECT_NEAR(rival.state().mean(2), 0.5, 0.01);
  EXPECT_NEAR(rival.state().covariance(2, 2), 0.01, 1e-4);
}

TEST(UnbiasedRival, IsAKalmanFilterOfOdometryAndFixes) {
  UnbiasedRival rival(settled(), fix_at(3.1, -2.2), kR, kBiasSigma);
  UnbiasedRival::State expected = rival.state();
  const OdometryIncrement u{1.0, 1.0, 0.8, 0.2};
  const OdometryNoise noise;
  const auto step = odometry_state::step(expected.mean, u, noise);
  kalman::predict<odometry_state::kSize>(expected, step.mean, step.F, step.Q);
  rival.predict(u, noise);
  GnssFix fix = fix_at(4.2, -1.4);
  fix.antenna_in_base = {0.3, 0.1};
  const auto H = odometry_state::antenna_jacobian(expected.mean, fix.antenna_in_base);
  const Eigen::Vector2d y = fix.position - odometry_state::pose(expected.mean) * fix.antenna_in_base;
  const auto taken = kalman::correct<odometry_state::kSize, 2>(expected, y, H, kR);
  const double before = rival.log_odds();
  rival.weigh(fix, kR, 1.0, -3.0);
  EXPECT_TRUE(rival.state().mean.isApprox(expected.mean, 1e-12));
  EXPECT_TRUE(rival.state().covariance.isApprox(expected.covariance, 1e-12));
  EXPECT_NEAR(rival.log_odds() - before, taken.log_likelihood + 3.0, 1e-12);
}

TEST(UnbiasedRival, AShareOfAFixTellsASharesWorth) {
  UnbiasedRival whole(settled(), fix_at(3.0, -2.0), kR, kBiasSigma);
  UnbiasedRival share = whole;
  const double before = whole.log_odds();
  whole.weigh(fix_at(3.2, -2.0), kR, 1.0, -3.0);
  share.weigh(fix_at(3.2, -2.0), kR, 0.1, -3.0);
  EXPECT_NEAR(share.log_odds() - before, 0.1 * (whole.log_odds() - before), 1e-12);
  EXPECT_GT(share.state().covariance(0, 0), whole.state().covariance(0, 0));
}

}  // namespace
}  // namespace multipath_localization
