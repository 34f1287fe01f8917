#include <gtest/gtest.h>

#include <vector>

#include "multipath_localization/models/preintegrated_odometry.hpp"

namespace multipath_localization {
namespace {

/// A second of winding driving at 50 Hz.
std::vector<OdometryIncrement> winding() {
  std::vector<OdometryIncrement> all;
  for (int i = 0; i < 50; ++i) all.push_back({0.02 * (i + 1), 0.02, 2.0 + 0.01 * i, 0.8 * std::cos(0.1 * i)});
  return all;
}

PreintegratedOdometry summed(double scale, double gyro_bias) {
  PreintegratedOdometry sum{OdometryNoise{}};
  sum.restart(scale, gyro_bias);
  for (const OdometryIncrement& u : winding()) sum.add(u);
  return sum;
}

TEST(PreintegratedOdometry, IsTheComposedDisplacementWithTheConstantsTakenOut) {
  const double scale = 0.02;
  const double gyro_bias = 0.01;
  Pose2 expected;
  for (OdometryIncrement u : winding()) {
    u.speed /= 1.0 + scale;
    u.yaw_rate -= gyro_bias;
    expected = expected * displacement(u);
  }
  const PreintegratedOdometry sum = summed(scale, gyro_bias);
  EXPECT_LT((sum.displacement(scale, gyro_bias) - expected.position()).norm(), 1e-4);
  EXPECT_NEAR(sum.turn(gyro_bias), expected.yaw, 1e-9);
  EXPECT_NEAR(sum.moving_time(), 1.0, 1e-9);
}

TEST(PreintegratedOdometry, DerivativesAreCentralDifferences) {
  const double step = 1e-5;
  const PreintegratedOdometry sum = summed(0.02, 0.01);
  const auto at = [](double scale, double gyro_bias) {
    return summed(scale, gyro_bias).displacement(scale, gyro_bias);
  };
  const Eigen::Vector2d by_scale = (at(0.02 + step, 0.01) - at(0.02 - step, 0.01)) / (2.0 * step);
  const Eigen::Vector2d by_gyro_bias = (at(0.02, 0.01 + step) - at(0.02, 0.01 - step)) / (2.0 * step);
  EXPECT_LT((sum.by_scale() - by_scale).norm(), 1e-6);
  EXPECT_LT((sum.by_gyro_bias() - by_gyro_bias).norm(), 1e-6);
  EXPECT_NEAR(sum.turn(0.01 + step) - sum.turn(0.01), -step, 1e-9);
}

TEST(PreintegratedOdometry, StandingAddsTimeAndNothingElse) {
  PreintegratedOdometry sum{OdometryNoise{}};
  for (int i = 0; i < 100; ++i) sum.add({0.0, 0.1, 0.0, 0.0});
  EXPECT_NEAR(sum.duration(), 10.0, 1e-9);
  EXPECT_EQ(sum.moving_time(), 0.0);
  EXPECT_EQ(sum.turn(0.0), 0.0);
  EXPECT_TRUE(sum.covariance().isZero());
}

TEST(PreintegratedOdometry, NoiseGrowsWithDistanceAndTime) {
  const OdometryNoise noise;
  PreintegratedOdometry sum{noise};
  for (int i = 0; i < 500; ++i) sum.add({0.0, 0.02, -2.0, 0.0});
  const Eigen::Matrix3d& P = sum.covariance();
  EXPECT_NEAR(P(0, 0), noise.distance * noise.distance * 20.0, 1e-9);
  EXPECT_NEAR(P(2, 2), noise.yaw * noise.yaw * 10.0, 1e-9);
  EXPECT_NEAR(P(1, 1), noise.yaw * noise.yaw * 4.0 * 1000.0 / 3.0, 1e-4);  // yaw^2 v^2 t^3 / 3
  EXPECT_LT((P - P.transpose()).norm(), 1e-15);
}

}  // namespace
}  // namespace multipath_localization
