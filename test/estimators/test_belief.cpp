#include <gtest/gtest.h>

#include <Eigen/LU>

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
    for (int i = 0; i < kStateSize; ++i) {
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
    EXPECT_TRUE(symmetric_positive(moved.covariance));
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
  EXPECT_EQ(belief.mean.tail<4>(), before.tail<4>());
}

TEST(Belief, KeepsTheHeadingOnTheCircle) {
  Belief belief;
  for (int turn = 0; turn < 3; ++turn) {
    PreintegratedOdometry odometry{OdometryNoise{}};
    for (int i = 1; i <= 50; ++i) odometry.add({0.1 * i, 0.1, 1.0, 1.0});
    belief.propagate(odometry, OdometryNoise{});
    EXPECT_NEAR(belief.mean(kYaw), wrap_angle(5.0 * (turn + 1)), 1e-9);
  }
  belief.mean(kYaw) = 3.1;
  belief.covariance.setIdentity();
  belief.correct(belief.pose() * kAntenna + Eigen::Vector2d(0.1, -1.0), kAntenna, 0.01);
  EXPECT_LT(belief.mean(kYaw), kPi);
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

TEST(Belief, CorrectsAsTheTextbookSays) {
  const double r = 0.09;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Belief belief = random_belief(seed);
    const auto H = numerical_fix_jacobian(belief, kAntenna);
    const Belief::Matrix P = belief.covariance;
    const Eigen::Matrix2d S = H * P * H.transpose() + r * Eigen::Matrix2d::Identity();
    const Eigen::Matrix<double, kStateSize, 2> K = P * H.transpose() * S.inverse();
    const Eigen::Vector2d fix(2.0, -1.5);
    const Eigen::Vector2d expected_fix = belief.pose() * kAntenna + belief.mean.tail<2>();
    Belief::Vector mean = belief.mean + K * (fix - expected_fix);
    mean(kYaw) = wrap_angle(mean(kYaw));
    const Belief::Matrix covariance = P - K * S * K.transpose();

    belief.correct(fix, kAntenna, r);
    EXPECT_LT((belief.mean - mean).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT((belief.covariance - covariance).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_TRUE(symmetric_positive(belief.covariance));
  }
}

TEST(Belief, StaysSymmetricAndPositiveOverAnHourOfFixes) {
  Belief belief = random_belief(5);
  const PreintegratedOdometry odometry = some_odometry();
  for (int i = 0; i < 3600; ++i) {
    belief.propagate(odometry, OdometryNoise{});
    belief.decay_bias(0.95, 0.01);
    belief.correct(belief.pose() * kAntenna, kAntenna, 1e-4);
  }
  EXPECT_TRUE(symmetric_positive(belief.covariance));
}

TEST(Belief, DecayIsOneStepOfAGaussMarkovProcess) {
  Belief belief = random_belief(2);
  Belief::Matrix D = Belief::Matrix::Identity();
  D(kBiasX, kBiasX) = D(kBiasY, kBiasY) = 0.7;
  Belief::Matrix expected = D * belief.covariance * D.transpose();
  expected(kBiasX, kBiasX) += 0.3;
  expected(kBiasY, kBiasY) += 0.3;
  const Belief::Vector mean = D * belief.mean;
  belief.decay_bias(0.7, 0.3);
  EXPECT_LT((belief.mean - mean).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((belief.covariance - expected).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_TRUE(symmetric_positive(belief.covariance));
}

TEST(Belief, RenewingForgetsOneStateAndNothingElse) {
  const Belief before = random_belief(3);
  Belief belief = before;
  belief.renew(kYaw, 0.5, 0.04);
  for (int i = 0; i < kStateSize; ++i) {
    for (int j = 0; j < kStateSize; ++j) {
      const double other = i == kYaw || j == kYaw ? 0.0 : before.covariance(i, j);
      EXPECT_EQ(belief.covariance(i, j), i == kYaw && j == kYaw ? 0.04 : other);
    }
    EXPECT_EQ(belief.mean(i), i == kYaw ? 0.5 : before.mean(i));
  }
  EXPECT_TRUE(symmetric_positive(belief.covariance));

  belief.renew_bias(9.0);
  EXPECT_EQ(belief.mean.tail<2>(), Eigen::Vector2d::Zero());
  EXPECT_EQ((belief.covariance.bottomRightCorner<2, 2>()), 9.0 * Eigen::Matrix2d::Identity());
  EXPECT_EQ(belief.covariance.bottomLeftCorner(2, 5).norm(), 0.0);
  EXPECT_TRUE(symmetric_positive(belief.covariance));
}

TEST(Belief, MovedByItsBiasItExpectsTheSameFixes) {
  const Belief before = random_belief(4);
  Belief belief = before;
  belief.move_by_bias(0.04);
  const FixPrediction was(before, kAntenna);
  const FixPrediction is(belief, kAntenna);
  EXPECT_LT((is.antenna - (was.antenna + was.bias)).norm(), 1e-12);
  EXPECT_EQ(is.bias, Eigen::Vector2d::Zero());
  const Eigen::Matrix2d sum = was.antenna_covariance + was.cross_covariance + was.bias_covariance;
  EXPECT_LT((is.antenna_covariance - sum).norm(), 1e-12);
  EXPECT_EQ(is.bias_covariance, 0.04 * Eigen::Matrix2d::Identity());
  EXPECT_EQ(belief.mean(kYaw), before.mean(kYaw));
  EXPECT_TRUE(symmetric_positive(belief.covariance));
}

TEST(FixPrediction, PartsAddUpToTheCovarianceOfTheFix) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Belief belief = random_belief(seed);
    const FixPrediction prediction(belief, kAntenna);
    const auto H = numerical_fix_jacobian(belief, kAntenna);
    const Eigen::Matrix2d sum =
        prediction.antenna_covariance + prediction.cross_covariance + prediction.bias_covariance;
    EXPECT_LT((sum - H * belief.covariance * H.transpose()).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT((prediction.antenna - belief.pose() * kAntenna).norm(), 1e-12);
    EXPECT_EQ(prediction.bias, Eigen::Vector2d(belief.mean.tail<2>()));
  }
}

}  // namespace
}  // namespace multipath_localization
