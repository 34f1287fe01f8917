#include <gtest/gtest.h>

#include "random_belief.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector2d kAntenna(1.2, -0.4);

PreintegratedOdometry some_odometry() {
  PreintegratedOdometry odometry{OdometryNoise{}};
  odometry.restart(0.01, -0.002);
  for (int i = 1; i <= 50; ++i) odometry.add({0.02 * i, 0.02, 2.0 - 0.05 * i, 0.4});
  return odometry;
}

TEST(Belief, PropagatesItsCovarianceByTheDerivativeOfItsMean) {
  const PreintegratedOdometry odometry = some_odometry();
  OdometryNoise noise;
  noise.scale_walk = noise.gyro_bias_walk = 0.01;
  constexpr double kDelta = 1e-6;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Belief start = random_belief(seed);
    Belief::Matrix F;
    for (int i = 0; i < kPlanarSize; ++i) {
      Belief high = start;
      Belief low = start;
      high.mean(i) += kDelta;
      low.mean(i) -= kDelta;
      high.propagate(odometry, noise);
      low.propagate(odometry, noise);
      Belief::Vector difference = high.mean - low.mean;
      difference(kYaw) = wrap_angle(difference(kYaw));
      F.col(i) = difference / (2.0 * kDelta);
    }
    Belief::Matrix Q = Belief::Matrix::Zero();
    Eigen::Matrix3d G = Eigen::Matrix3d::Identity();
    G.topLeftCorner<2, 2>() = rotation(start.mean(kYaw));
    Q.topLeftCorner<3, 3>() = G * odometry.covariance() * G.transpose();
    Q(kScale, kScale) = noise.scale_walk * noise.scale_walk * odometry.moving_time();
    Q(kGyroBias, kGyroBias) = noise.gyro_bias_walk * noise.gyro_bias_walk * odometry.moving_time();

    Belief moved = start;
    moved.propagate(odometry, noise);
    const Belief::Matrix expected = F * start.covariance * F.transpose() + Q;
    EXPECT_LT((moved.covariance - expected).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT((moved.covariance - moved.covariance.transpose()).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(Belief, MovesAsTheOdometrySays) {
  const PreintegratedOdometry odometry = some_odometry();
  Belief belief = random_belief(1);
  const Pose2 increment{odometry.displacement(belief.mean(kScale), belief.mean(kGyroBias)).x(),
                        odometry.displacement(belief.mean(kScale), belief.mean(kGyroBias)).y(),
                        odometry.turn(belief.mean(kGyroBias))};
  const Pose2 expected = belief.pose() * increment;
  const Belief::Vector before = belief.mean;
  belief.propagate(odometry, OdometryNoise{});
  EXPECT_LT((belief.pose().position() - expected.position()).norm(), 1e-12);
  EXPECT_NEAR(angle_difference(belief.mean(kYaw), expected.yaw), 0.0, 1e-12);
  EXPECT_EQ(belief.mean.tail<2>(), before.tail<2>());
}

TEST(Belief, KeepsTheHeadingOnTheCircle) {
  Belief belief;
  for (int turn = 0; turn < 3; ++turn) {
    PreintegratedOdometry odometry{OdometryNoise{}};
    for (int i = 1; i <= 50; ++i) odometry.add({0.1 * i, 0.1, 1.0, 1.0});
    belief.propagate(odometry, OdometryNoise{});
    EXPECT_NEAR(belief.mean(kYaw), wrap_angle(5.0 * (turn + 1)), 1e-9);
  }
}

TEST(Belief, AParkedRobotStaysAsItIs) {
  PreintegratedOdometry odometry{OdometryNoise{}};
  for (int i = 1; i <= 100; ++i) odometry.add({0.1 * i, 0.1, 0.0, 0.0});
  Belief belief = random_belief(4);
  const Belief before = belief;
  belief.propagate(odometry, OdometryNoise{});
  EXPECT_LT((belief.mean - before.mean).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(belief.covariance, before.covariance);
}

TEST(AntennaPrediction, HasTheCovarianceOfThePoseByItsDerivative) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Belief belief = random_belief(seed);
    const AntennaPrediction antenna(belief, kAntenna);
    const auto H = numerical_antenna_jacobian(belief, kAntenna);
    EXPECT_LT((antenna.covariance - H * belief.covariance * H.transpose()).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT((antenna.position - belief.pose() * kAntenna).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace multipath_localization
