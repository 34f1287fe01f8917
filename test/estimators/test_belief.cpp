#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/estimators/belief.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector2d kAntenna(0.8, -0.3);

/// A belief with every state correlated with every other.
Belief some_belief() {
  Belief belief;
  belief.mean << 3.0, -4.0, 0.7, 0.01, 0.002, 1.5, -0.5;
  RandomStream random(1, 0, 0);
  Belief::Matrix A;
  for (Eigen::Index i = 0; i < A.size(); ++i) A(i) = 0.1 * random.normal();
  belief.covariance = A * A.transpose() + 0.01 * Belief::Matrix::Identity();
  return belief;
}

PreintegratedOdometry some_odometry() {
  PreintegratedOdometry odometry{OdometryNoise{}};
  odometry.restart(0.01, 0.002);
  for (int i = 0; i < 20; ++i) odometry.add({0.02 * i, 0.02, 2.0, 0.5});
  return odometry;
}

/// The fix that a state predicts.
Eigen::Vector2d predicted_fix(const Belief::Vector& state) {
  return Pose2{state(kX), state(kY), state(kYaw)} * kAntenna + state.tail<2>();
}

template <class Function>
auto central_differences(const Function& f, const Belief::Vector& at) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, Eigen::Dynamic, kStateSize> J(f(at).size(), static_cast<Eigen::Index>(kStateSize));
  for (Eigen::Index i = 0; i < kStateSize; ++i) {
    const Belief::Vector step = kStep * Belief::Vector::Unit(i);
    J.col(i) = (f(at + step) - f(at - step)) / (2.0 * kStep);
  }
  return J;
}

TEST(Belief, PropagationIsThatOfItsJacobian) {
  OdometryNoise noise;
  noise.scale_walk = noise.gyro_bias_walk = 0.0;
  const PreintegratedOdometry odometry = some_odometry();
  const auto moved = [&](const Belief::Vector& state) {
    Belief belief;
    belief.mean = state;
    belief.propagate(odometry, noise);
    return belief.mean;
  };
  Belief belief = some_belief();
  const Belief before = belief;
  belief.propagate(odometry, noise);
  const Belief::Matrix F = central_differences(moved, before.mean);
  Belief::Matrix expected = F * before.covariance * F.transpose();
  Eigen::Matrix3d G = Eigen::Matrix3d::Identity();
  G.topLeftCorner<2, 2>() = rotation(before.mean(kYaw));
  expected.topLeftCorner<3, 3>() += G * odometry.covariance() * G.transpose();
  EXPECT_LT((belief.covariance - expected).norm(), 1e-8);
}

TEST(Belief, PropagationTwiceBackAndForthEndsInPlace) {
  Belief belief;
  PreintegratedOdometry forth{OdometryNoise{}};
  PreintegratedOdometry back{OdometryNoise{}};
  forth.add({0.0, 0.5, 2.0, 0.0});
  back.add({0.5, 0.5, -2.0, 0.0});
  belief.mean(kYaw) = 1.0;
  belief.propagate(forth, OdometryNoise{});
  EXPECT_NEAR(belief.mean.head<2>().norm(), 1.0, 1e-12);
  belief.propagate(back, OdometryNoise{});
  EXPECT_NEAR(belief.mean.head<2>().norm(), 0.0, 1e-12);
}

TEST(Belief, CorrectionIsTheTextbookKalmanUpdate) {
  const Belief before = some_belief();
  const double r = 0.09;
  const Eigen::Vector2d fix(5.0, -3.0);
  const Eigen::Matrix<double, 2, kStateSize> H = central_differences(predicted_fix, before.mean);
  const Eigen::Matrix2d S = H * before.covariance * H.transpose() + r * Eigen::Matrix2d::Identity();
  const Eigen::Matrix<double, kStateSize, 2> K = before.covariance * H.transpose() * S.inverse();

  Belief after = before;
  after.correct(fix, kAntenna, r);
  EXPECT_LT((after.mean - before.mean - K * (fix - predicted_fix(before.mean))).norm(), 1e-7);
  EXPECT_LT((after.covariance - (Belief::Matrix::Identity() - K * H) * before.covariance).norm(), 1e-7);
}

TEST(Belief, StaysSymmetricAndPositiveOverManyCorrections) {
  Belief belief = some_belief();
  for (int i = 0; i < 20000; ++i) {
    belief.decay_bias(0.99, 0.001);
    belief.correct(predicted_fix(belief.mean) + Eigen::Vector2d(0.1, -0.1), kAntenna, 1e-4);
  }
  EXPECT_LT((belief.covariance - belief.covariance.transpose()).norm(), 1e-9);
  EXPECT_GT(belief.covariance.llt().matrixL().determinant(), 0.0);
  EXPECT_EQ(belief.covariance.llt().info(), Eigen::Success);
}

TEST(Belief, BiasDecaysToItsStationaryVariance) {
  Belief belief = some_belief();
  const double factor = 0.9;
  for (int i = 0; i < 300; ++i) belief.decay_bias(factor, 4.0 * (1.0 - factor * factor));
  EXPECT_NEAR(belief.mean.tail<2>().norm(), 0.0, 1e-9);
  EXPECT_NEAR(belief.covariance(kBiasX, kBiasX), 4.0, 1e-9);
  EXPECT_NEAR(belief.covariance(kX, kBiasX), 0.0, 1e-9);
}

TEST(Belief, ARenewedStateForgetsItsPastAndLeavesTheRest) {
  const Belief before = some_belief();
  Belief after = before;
  after.renew(kYaw, 1.0, 0.25);
  EXPECT_EQ(after.mean(kYaw), 1.0);
  EXPECT_EQ(after.covariance(kYaw, kYaw), 0.25);
  EXPECT_EQ(after.covariance.row(kYaw).cwiseAbs().sum(), 0.25);
  EXPECT_EQ(after.covariance(kX, kBiasY), before.covariance(kX, kBiasY));
  EXPECT_EQ(after.mean(kScale), before.mean(kScale));
}

TEST(FixPrediction, PartsAddUpToTheWholeInnovationCovariance) {
  const Belief belief = some_belief();
  const FixPrediction prediction(belief, kAntenna);
  const Eigen::Matrix<double, 2, kStateSize> H = central_differences(predicted_fix, belief.mean);
  const Eigen::Matrix2d expected = H * belief.covariance * H.transpose();
  const Eigen::Matrix2d sum =
      prediction.antenna_covariance + prediction.bias_covariance + prediction.cross_covariance;
  EXPECT_LT((sum - expected).norm(), 1e-8);
  EXPECT_LT((prediction.antenna + prediction.bias - predicted_fix(belief.mean)).norm(), 1e-12);
}

}  // namespace
}  // namespace multipath_localization
