#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "estimators/multipath/hypothesis.hpp"
#include "multipath_localization/core/random.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {
namespace {

const OdometryNoise kNoise = {0.005, 0.002, 0.03, 0.004, 1.5e-4, 2e-5};

/// Everything correlated with everything.
Hypothesis some_hypothesis(std::uint32_t number) {
  RandomStream random(7, 1, number);
  Hypothesis h;
  State sigma;
  sigma << 1.0, 1.0, 0.1, 0.02, 0.004, 0.03, 0.01, 0.005, 0.5, 0.5, 3.0, 3.0;
  StateCovariance root;
  for (int i = 0; i < kStateSize; ++i) {
    h.mean(i) = sigma(i) * random.normal();
    for (int j = 0; j < kStateSize; ++j) root(i, j) = sigma(i) * random.normal() / 3.0;
  }
  h.covariance = root * root.transpose();
  h.level = 0.5;
  return h;
}

OdometrySum some_odometry(const OdometryErrors& errors) {
  OdometrySum sum(kNoise);
  sum.restart(errors);
  for (int i = 1; i <= 50; ++i) sum.add({0.02 * i, 0.02, 2.0, 0.5});
  return sum;
}

GnssFix some_fix() {
  GnssFix fix;
  fix.position = {1.0, -2.0};
  fix.covariance = (Eigen::Matrix2d() << 0.3, 0.1, 0.1, 0.2).finished();
  fix.antenna_in_base = {0.8, -0.3};
  return fix;
}

TEST(Hypothesis, MovesAsTheOdometryWithItsOwnErrorsSays) {
  Hypothesis h;
  h.mean << 3.0, -1.0, 2.0, 0.01, 0.002, 0.02, 0.003, 0.0, 0.0, 0.0, 0.0, 0.0;
  const Pose2 start = h.pose();
  const OdometrySum exact = some_odometry({0.01, 0.002, 0.02, 0.003});
  h.propagate(some_odometry({}), kNoise);
  const Pose2 end = start * Pose2{exact.displacement().x(), exact.displacement().y(), exact.turn()};
  EXPECT_LT((h.pose().position() - end.position()).norm(), 2e-3);
  EXPECT_NEAR(h.mean(kYaw), end.yaw, 1e-4);
}

TEST(Hypothesis, PropagatesItsCovarianceByTheDerivativeOfItsMean) {
  Hypothesis h = some_hypothesis(1);
  const OdometrySum odometry = some_odometry({});
  const OdometrySum none(kNoise);
  Eigen::Matrix<double, kStateSize, kStateSize> F;
  constexpr double kStep = 1e-6;
  for (int i = 0; i < kStateSize; ++i) {
    Hypothesis up = h;
    Hypothesis down = h;
    up.mean(i) += kStep;
    down.mean(i) -= kStep;
    up.propagate(odometry, kNoise);
    down.propagate(odometry, kNoise);
    F.col(i) = (up.mean - down.mean) / (2.0 * kStep);
  }
  StateCovariance expected = F * h.covariance * F.transpose();
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  turned.topLeftCorner<2, 2>() = rotation(h.mean(kYaw));
  expected.topLeftCorner<3, 3>() += turned * odometry.noise().total({}) * turned.transpose();
  expected(kScale, kScale) += square(kNoise.scale_walk) * odometry.moving_time();
  expected(kGyroBias, kGyroBias) += square(kNoise.gyro_bias_walk) * odometry.moving_time();
  h.propagate(odometry, kNoise);
  EXPECT_LT((h.covariance - expected).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Hypothesis, PlacedAtAFixItExpectsThatFix) {
  Hypothesis h = some_hypothesis(2);
  h.in_shadow = true;
  h.shadow_law.size = 4.0;
  h.renew_heading(0.7, 0.01);
  h.place_at(some_fix());
  EXPECT_LT((h.pose() * some_fix().antenna_in_base - some_fix().position).norm(), 1e-12);
  EXPECT_EQ(h.bias(), Eigen::Vector2d::Zero());
  // Position and biases are off together: what a fix is off by is its white noise alone.
  Eigen::Matrix<double, 2, kStateSize> H = Eigen::Matrix<double, 2, kStateSize>::Zero();
  H.leftCols<2>().setIdentity();
  H.block<2, 2>(0, kSlowX).setIdentity();
  H.block<2, 2>(0, kShadowX).setIdentity();
  const Eigen::Vector2d lever = rotation(0.7) * some_fix().antenna_in_base;
  H.col(kYaw) << -lever.y(), lever.x();
  const Eigen::Matrix2d S = H * h.covariance * H.transpose();
  EXPECT_LT((S - h.law.white_variance() * some_fix().covariance).norm(), 1e-9);
}

TEST(Hypothesis, CorrectsAsTheTextbookSays) {
  for (const bool shadow : {false, true}) {
    Hypothesis h = some_hypothesis(3);
    h.in_shadow = shadow;
    const Eigen::Vector2d lever = rotation(h.mean(kYaw)) * some_fix().antenna_in_base;
    Eigen::Matrix<double, 2, kStateSize> H = Eigen::Matrix<double, 2, kStateSize>::Zero();
    H.leftCols<2>().setIdentity();
    H.col(kYaw) << -lever.y(), lever.x();
    H.block<2, 2>(0, kSlowX).setIdentity();
    if (shadow) H.block<2, 2>(0, kShadowX).setIdentity();
    const Eigen::Matrix2d R = 0.3 * some_fix().covariance;
    const Eigen::Matrix<double, kStateSize, 2> K =
        h.covariance * H.transpose() * (H * h.covariance * H.transpose() + R).inverse();
    Eigen::Vector2d bias = h.mean.segment<2>(kSlowX);
    if (shadow) bias += h.mean.segment<2>(kShadowX);
    const State mean = h.mean + K * (some_fix().position - h.mean.head<2>() - lever - bias);
    const StateCovariance covariance = (StateCovariance::Identity() - K * H) * h.covariance;
    h.correct(some_fix(), R);
    EXPECT_LT((h.mean - mean).norm(), 1e-9);
    EXPECT_LT((h.covariance - covariance).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(Hypothesis, StaysSymmetricAndPositiveOverAnHourOfRtkFixes) {
  Hypothesis h = some_hypothesis(4);
  h.covariance.topRows<2>() *= 100.0;
  h.covariance.leftCols<2>() *= 100.0;
  h.mean.setZero();
  const OdometrySum odometry = some_odometry({});
  const Pose2 step{odometry.displacement().x(), odometry.displacement().y(), odometry.turn()};
  GnssFix fix = some_fix();
  Pose2 truth;
  for (int i = 0; i < 3600; ++i) {
    h.propagate(odometry, kNoise);
    decay(h, kSlowX, 0.99, 1e-8);
    truth = truth * step;
    fix.position = truth * fix.antenna_in_base;
    h.correct(fix, 1e-6 * Eigen::Matrix2d::Identity());
  }
  const Eigen::SelfAdjointEigenSolver<StateCovariance> solver(h.covariance, Eigen::EigenvaluesOnly);
  EXPECT_EQ((h.covariance - h.covariance.transpose()).norm(), 0.0);
  EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-12);
}

TEST(Hypothesis, KnowsTheSumOfItsErrorsBetterThanEachOfThem) {
  Hypothesis h;
  h.covariance.diagonal().segment<4>(kSlowX).setConstant(4.0);
  h.covariance.block<2, 2>(kSlowX, kShadowX).diagonal().setConstant(-3.5);
  h.covariance.block<2, 2>(kShadowX, kSlowX).diagonal().setConstant(-3.5);
  EXPECT_TRUE(h.bias_covariance().isApprox(Eigen::Matrix2d::Identity()));
}

TEST(Hypothesis, MovedByItsBiasItExpectsTheSameFixes) {
  Hypothesis h = some_hypothesis(6);
  const Eigen::Vector2d position = h.mean.head<2>() + h.mean.tail<2>();
  const Eigen::Matrix2d cross = h.covariance.block<2, 2>(kX, kShadowX);
  const Eigen::Matrix2d covariance =
      h.covariance.topLeftCorner<2, 2>() + cross + cross.transpose() + h.covariance.bottomRightCorner<2, 2>();
  move_by_bias(h);
  EXPECT_LT((h.mean.head<2>() - position).norm(), 1e-12);
  EXPECT_LT((h.covariance.topLeftCorner<2, 2>() - covariance).norm(), 1e-12);
  EXPECT_EQ(h.mean.tail<2>().norm(), 0.0);
  EXPECT_EQ(h.covariance.bottomRows<2>().norm(), 0.0);
}

TEST(Decay, IsOneStepOfAGaussMarkovProcess) {
  Hypothesis h = some_hypothesis(5);
  const Hypothesis before = h;
  decay(h, kShadowX, 0.8, 0.5);
  EXPECT_LT((h.mean.tail<2>() - 0.8 * before.mean.tail<2>()).norm(), 1e-12);
  EXPECT_NEAR(h.covariance(kShadowX, kShadowX), 0.64 * before.covariance(kShadowX, kShadowX) + 0.5, 1e-12);
  EXPECT_NEAR(h.covariance(kX, kShadowY), 0.8 * before.covariance(kX, kShadowY), 1e-12);
}

TEST(Hypothesis, LearnsTheBiasOfAGyroAtRest) {
  Hypothesis h;
  h.covariance(kImuBias, kImuBias) = square(0.01);
  OdometrySum odometry(OdometryNoise{});
  for (int i = 1; i <= 200; ++i) {
    OdometryIncrement u{0.1 * i, 0.1, 0.0, 0.0};
    u.rate_at_rest = 0.023;
    odometry.add(u);
  }
  h.propagate(odometry, OdometryNoise{});
  EXPECT_NEAR(h.mean(kImuBias), 0.023, 3e-4);
  EXPECT_LT(std::sqrt(h.covariance(kImuBias, kImuBias)), 1e-3);
  EXPECT_EQ(h.mean.head<3>(), Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace multipath_localization::multipath
