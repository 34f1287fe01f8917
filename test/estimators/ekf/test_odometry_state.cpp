#include <gtest/gtest.h>

#include <cmath>

#include "estimators/ekf/odometry_state.hpp"

namespace multipath_localization {
namespace {

using odometry_state::Matrix;
using odometry_state::Vector;

const OdometryIncrement kTurning{0.5, 0.5, 1.5, 0.4};

Vector somewhere() { return (Vector() << 3.0, -2.0, 0.7, 0.02, 0.005).finished(); }

TEST(OdometryState, StepTakesTheOdometersErrorsOut) {
  const Vector x = somewhere();
  const odometry_state::Step step = odometry_state::step(x, kTurning, OdometryNoise{});
  const Pose2 end = Pose2{x(0), x(1), x(2)} * displacement({0.5, 0.5, 1.5 / 1.02, 0.4 - 0.005});
  EXPECT_NEAR(step.mean(0), end.x, 1e-12);
  EXPECT_NEAR(step.mean(1), end.y, 1e-12);
  EXPECT_NEAR(step.mean(2), end.yaw, 1e-12);
  EXPECT_EQ(step.mean.tail<2>(), x.tail<2>());
}

TEST(OdometryState, JacobiansAreTheSlopes) {
  const Vector x = somewhere();
  const Eigen::Vector2d antenna(0.4, -0.2);
  const auto seen = [&](const Vector& at) { return Eigen::Vector2d(odometry_state::pose(at) * antenna); };
  const Matrix F = odometry_state::step(x, kTurning, OdometryNoise{}).F;
  const auto H = odometry_state::antenna_jacobian(x, antenna);
  constexpr double kSmall = 1e-6;
  for (int i = 0; i < odometry_state::kSize; ++i) {
    const Vector change = kSmall * Vector::Unit(i);
    const Vector slope = (odometry_state::step(x + change, kTurning, OdometryNoise{}).mean -
                          odometry_state::step(x - change, kTurning, OdometryNoise{}).mean) /
                         (2.0 * kSmall);
    EXPECT_TRUE(slope.isApprox(F.col(i), 1e-7)) << i;
    EXPECT_LT(((seen(x + change) - seen(x - change)) / (2.0 * kSmall) - H.col(i)).norm(), 1e-7) << i;
  }
}

TEST(OdometryState, NoiseGrowsWithTheWayAndWithTime) {
  OdometryNoise noise;
  noise.distance = 0.1;
  noise.yaw = 0.2;
  noise.scale_walk = 0.03;
  noise.gyro_bias_walk = 0.04;
  Vector x = somewhere();
  x(2) = 0.5 * kPi;
  const Matrix Q = odometry_state::step(x, {0.5, 0.5, -2.0, 0.0}, noise).Q;
  EXPECT_NEAR(Q(1, 1), 0.01 * 2.0 * 0.5, 1e-12);
  EXPECT_NEAR(Q(0, 0), 0.0, 1e-12);
  EXPECT_NEAR(Q(2, 2), 0.04 * 0.5, 1e-12);
  EXPECT_NEAR(Q(3, 3), 0.0009 * 0.5, 1e-12);
  EXPECT_NEAR(Q(4, 4), 0.0016 * 0.5, 1e-12);
}

TEST(OdometryState, UnknownCovarianceIsThatOfAUniformHeadingAndTheOdometersSigmas) {
  OdometryNoise noise;
  noise.scale_sigma = 0.05;
  noise.gyro_bias_sigma = 0.01;
  const Matrix P = odometry_state::unknown_covariance(noise);
  EXPECT_NEAR(P(2, 2), kPi * kPi / 3.0, 1e-12);
  EXPECT_NEAR(P(3, 3), 0.0025, 1e-15);
  EXPECT_NEAR(P(4, 4), 1e-4, 1e-15);
  EXPECT_TRUE(P.isDiagonal());
}

TEST(OdometryState, PoseIsWrapped) {
  Vector x = somewhere();
  x(2) = kPi + 0.5;
  EXPECT_NEAR(odometry_state::pose(x).yaw, 0.5 - kPi, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
