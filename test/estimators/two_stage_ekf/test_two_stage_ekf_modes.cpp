#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "estimators/gated_ekf/gated_ekf.hpp"
#include "estimators/two_stage_ekf/two_stage_ekf.hpp"
#include "matched_robot.hpp"
#include "two_stage_robot.hpp"

namespace multipath_localization {
namespace {

constexpr int kStates = odometry_state::kSize;

/// A constant bias from the start on, everything linearised at the bias-free estimate.
TwoStageEkfParameters friedland() {
  TwoStageEkfParameters parameters;
  parameters.bias_estimated = BiasEstimated::kAlways;
  parameters.bias_walk = 0.0;
  parameters.linearised_at = LinearisedAt::kBiasFree;
  parameters.fix_correlation_time = 0.0;
  return parameters;
}

TwoStageEkfParameters standard() {
  TwoStageEkfParameters parameters;
  parameters.compensate = false;
  parameters.fix_correlation_time = 0.0;
  return parameters;
}

TEST(TwoStageEkf, StandardModeIsTheExtendedKalmanFilter) {
  GatedEkfParameters ungated;
  ungated.gate = 1e6;
  ungated.declared = standard().declared;
  TwoStageEkf filter(standard());
  GatedEkf ekf(ungated);
  for (Estimator* each : {static_cast<Estimator*>(&filter), static_cast<Estimator*>(&ekf)}) {
    MatchedRobot robot(ungated.odometry, 3);
    each->start(std::nullopt);
    robot.run(*each, 40.0);
    robot.run(*each, 40.0, kBias);
  }
  EXPECT_TRUE(filter.estimate().aligned);
  expect_same(filter.estimate(), ekf.estimate(), 1e-9);
  EXPECT_FALSE(in_fault(filter));
}

/// Section 3.2 of [KIM] by hand, from a known start.
TEST(TwoStageEkf, LiteralModeIsFriedlandsEstimator) {
  const TwoStageEkfParameters parameters = friedland();
  TwoStageEkf filter(parameters);
  MatchedRobot robot = robot_of(parameters, 4);
  robot.antenna.setZero();
  const PosePrior prior = prior_at(robot.truth);
  filter.start(prior);
  TwoStage<kStates, 2> belief;
  belief.bias_free.covariance = odometry_state::unknown_covariance(parameters.odometry);
  belief.bias_free.covariance.topLeftCorner<3, 3>() = prior.covariance;
  belief.bias.covariance = 25.0 * Eigen::Matrix2d::Identity();
  Eigen::Matrix<double, 2, kStates> H = Eigen::Matrix<double, 2, kStates>::Zero();
  H.leftCols<2>().setIdentity();
  for (int i = 1; i <= 2000; ++i) {
    const OdometryIncrement u = robot.drive();
    filter.predict(u);
    const auto step = odometry_state::step(belief.bias_free.mean, u, parameters.odometry);
    two_stage::predict<kStates, 2>(belief, step.mean, step.F, Eigen::Matrix<double, kStates, 2>::Zero(),
                                   step.Q);
    if (i % MatchedRobot::kStepsPerFix != 0) continue;
    GnssFix fix = robot.fix();
    fix.position += kBias;
    filter.update(fix);
    two_stage::correct<kStates, 2, 2>(belief, fix.position - belief.bias_free.mean.head<2>(), H,
                                      Eigen::Matrix2d::Identity(), fix.covariance);
  }
  const Gaussian<kStates> corrected = two_stage::corrected(belief);
  EXPECT_LT((filter.estimate().pose.position() - corrected.mean.head<2>()).norm(), 1e-9);
  EXPECT_LT((filter.estimate().bias - belief.bias.mean).norm(), 1e-9);
  EXPECT_TRUE(filter.estimate().covariance.isApprox(corrected.covariance.topLeftCorner<3, 3>(), 1e-9));
  EXPECT_LT((belief.bias.mean - kBias).norm(), 3.0 * std::sqrt(belief.bias.covariance.trace()));
  EXPECT_LT(belief.bias.covariance.trace(), 1.5);
}

/// With everything linearised at the corrected estimate, the two stages are the extended Kalman filter over
/// pose, odometer's errors and bias.
TEST(TwoStageEkf, EqualsTheAugmentedFilterForAWalkingBias) {
  TwoStageEkfParameters parameters;
  parameters.bias_estimated = BiasEstimated::kAlways;
  parameters.fix_correlation_time = 0.0;
  TwoStageEkf filter(parameters);
  MatchedRobot robot = robot_of(parameters, 5);
  const PosePrior prior = prior_at(robot.truth);
  filter.start(prior);
  const double walk = parameters.bias_walk;
  Gaussian<kStates + 2> joint;
  joint.covariance.topLeftCorner<kStates, kStates>() =
      odometry_state::unknown_covariance(parameters.odometry);
  joint.covariance.topLeftCorner<3, 3>() = prior.covariance;
  joint.covariance.bottomRightCorner<2, 2>() *= 25.0;
  for (int i = 1; i <= 3000; ++i) {
    const OdometryIncrement u = robot.drive();
    filter.predict(u);
    const auto step = odometry_state::step(joint.mean.head<kStates>(), u, parameters.odometry);
    const double kept = std::exp(-0.5 * walk * walk * u.speed * u.duration / 25.0);
    Eigen::Matrix<double, 7, 7> F = kept * Eigen::Matrix<double, 7, 7>::Identity();
    Eigen::Matrix<double, 7, 7> Q = 25.0 * (1.0 - kept * kept) * Eigen::Matrix<double, 7, 7>::Identity();
    F.topLeftCorner<kStates, kStates>() = step.F;
    Q.topLeftCorner<kStates, kStates>() = step.Q;
    Eigen::Matrix<double, 7, 1> mean;
    mean << step.mean, kept * joint.mean.tail<2>();
    kalman::predict<7>(joint, mean, F, Q);
    if (i % MatchedRobot::kStepsPerFix != 0) continue;
    GnssFix fix = robot.fix();
    fix.position += kBias;
    const Innovation seen = filter.update(fix);
    Eigen::Matrix<double, 2, 7> H;
    H << odometry_state::antenna_jacobian(joint.mean.head<kStates>(), fix.antenna_in_base),
        Eigen::Matrix2d::Identity();
    const Pose2 pose = odometry_state::pose(joint.mean.head<kStates>());
    const Eigen::Vector2d y = fix.position - pose * fix.antenna_in_base - joint.mean.tail<2>();
    const auto expected = kalman::correct<7, 2>(joint, y, H, fix.covariance);
    ASSERT_NEAR(seen.nis, expected.nis, 1e-6);
  }
  EXPECT_LT((filter.estimate().pose.position() - joint.mean.head<2>()).norm(), 1e-8);
  EXPECT_LT((filter.estimate().bias - joint.mean.tail<2>()).norm(), 1e-8);
  EXPECT_TRUE(filter.estimate().covariance.isApprox(joint.covariance.topLeftCorner<3, 3>(), 1e-8));
}

TEST(TwoStageEkf, IsFarNearerThanTheStandardFilter) {
  TwoStageEkf compensated{TwoStageEkfParameters{}};
  TwoStageEkf plain(standard());
  std::vector<double> errors;
  for (TwoStageEkf* filter : {&compensated, &plain}) {
    MatchedRobot robot = robot_of(TwoStageEkfParameters{}, 9);
    settle(*filter, robot);
    robot.run(*filter, 20.0, kBias);
    errors.push_back(error(*filter, robot).norm());
  }
  EXPECT_LT(errors[0], 0.3 * errors[1]);
}

/// A position that came from fixes with a constant bias cannot be told from it.
TEST(TwoStageEkf, LiteralModeDoesNotTrustAStartFromTheFixes) {
  const TwoStageEkfParameters parameters = friedland();
  MatchedRobot robot = robot_of(parameters, 13);
  TwoStageEkf filter(parameters);
  filter.start(std::nullopt);
  robot.run(filter, 60.0, kBias);
  EXPECT_TRUE(filter.estimate().aligned);
  EXPECT_GT(sigma(filter), 4.9);
  EXPECT_LT(nees(filter, robot), 5.99);
}

/// x, y and heading alone, as [KIM] has it.
TEST(TwoStageEkf, KnowsNoOdometersErrorsWithoutTheirSigmas) {
  TwoStageEkfParameters parameters;
  parameters.odometry.scale_sigma = parameters.odometry.scale_walk = 0.0;
  parameters.odometry.gyro_bias_sigma = parameters.odometry.gyro_bias_walk = 0.0;
  constexpr int kSeeds = 20;
  double nees_sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    MatchedRobot robot = robot_of(parameters, seed);
    TwoStageEkf filter(parameters);
    settle(filter, robot);
    robot.run(filter, 20.0, kBias);
    EXPECT_TRUE(in_fault(filter));
    nees_sum += nees(filter, robot);
  }
  EXPECT_LT(nees_sum / kSeeds, 2.0 + 3.3 * std::sqrt(4.0 / kSeeds));
}

}  // namespace
}  // namespace multipath_localization
