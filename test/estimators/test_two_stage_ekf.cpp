#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <vector>

#include "matched_robot.hpp"
#include "multipath_localization/estimators/gated_ekf.hpp"
#include "multipath_localization/estimators/two_stage_ekf.hpp"

namespace multipath_localization {
namespace {

constexpr int kStates = odometry_state::kSize;

constexpr double kExactly = 1e-300;

const Eigen::Vector2d kBias(4.0, -3.0);

/// A constant bias from the start on, everything linearised at the bias-free estimate.
TwoStageEkfParameters friedland() {
  TwoStageEkfParameters parameters;
  parameters.bias_estimated = "always";
  parameters.bias_walk = 0.0;
  parameters.linearised_at = "bias_free";
  parameters.fix_correlation_time = 0.0;
  return parameters;
}

TwoStageEkfParameters standard() {
  TwoStageEkfParameters parameters;
  parameters.compensate = false;
  parameters.fix_correlation_time = 0.0;
  return parameters;
}

MatchedRobot robot_of(const TwoStageEkfParameters& parameters, std::uint64_t seed) {
  return {parameters.odometry, seed};
}

Eigen::Vector2d error(const Estimator& filter, const MatchedRobot& robot) {
  return filter.estimate().pose.position() - robot.truth.position();
}

double nees(const Estimator& filter, const MatchedRobot& robot) {
  const Eigen::Vector2d e = error(filter, robot);
  return e.dot(filter.estimate().position_covariance_overall.inverse() * e);
}

double sigma(const Estimator& filter) {
  return std::sqrt(0.5 * filter.estimate().position_covariance_overall.trace());
}

bool in_fault(const Estimator& filter) { return filter.estimate().shadow_probability == 1.0; }

/// Drives a filter that knows its start for a minute under open sky.
void settle(Estimator& filter, MatchedRobot& robot) {
  filter.start(prior_at(robot.truth));
  robot.run(filter, 60.0);
}

void expect_same(const PoseEstimate& a, const PoseEstimate& b, double tolerance) {
  EXPECT_EQ(a.valid, b.valid);
  EXPECT_EQ(a.aligned, b.aligned);
  EXPECT_NEAR(a.pose.x, b.pose.x, tolerance);
  EXPECT_NEAR(a.pose.y, b.pose.y, tolerance);
  EXPECT_NEAR(angle_difference(a.pose.yaw, b.pose.yaw), 0.0, tolerance);
  EXPECT_LT((a.covariance - b.covariance).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LT((a.bias - b.bias).norm(), tolerance);
  EXPECT_LT((a.bias_covariance - b.bias_covariance).cwiseAbs().maxCoeff(), tolerance);
}

/// A fix at rest, `offset` beside the prior: S is the prior's 0.25 + the fix's 0.25 m^2.
bool detects(double normalised_innovation_squared) {
  TwoStageEkf filter{TwoStageEkfParameters{}};
  filter.start(prior_at({}));
  GnssFix fix;
  fix.position = {std::sqrt(0.5 * normalised_innovation_squared), 0.0};
  fix.covariance = 0.25 * Eigen::Matrix2d::Identity();
  const Innovation innovation = filter.update(fix);
  EXPECT_NEAR(innovation.nis, normalised_innovation_squared, 1e-9);
  EXPECT_TRUE(innovation.accepted());
  EXPECT_EQ(in_fault(filter), filter.hypotheses().front().mode == Mode::kShadow);
  return in_fault(filter);
}

TEST(TwoStageEkf, DetectsAFaultAtThePrintedThreshold) {
  EXPECT_FALSE(detects(7.80));
  EXPECT_TRUE(detects(7.82));
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
  parameters.bias_estimated = "always";
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

TEST(TwoStageEkf, FindsAConstantBiasAndKnowsHowWell) {
  constexpr int kSeeds = 40;
  double nees_sum = 0.0;
  double squared_error = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const TwoStageEkfParameters parameters;
    MatchedRobot robot = robot_of(parameters, seed);
    TwoStageEkf filter(parameters);
    settle(filter, robot);
    const double sigma_before = sigma(filter);
    robot.run(filter, 30.0, kBias);
    ASSERT_TRUE(in_fault(filter));
    EXPECT_GT(sigma(filter), 1.5 * sigma_before);
    EXPECT_LT((filter.estimate().bias - kBias).norm(), 3.5);
    nees_sum += nees(filter, robot);
    squared_error += error(filter, robot).squaredNorm();
  }
  EXPECT_LT(std::sqrt(squared_error / kSeeds), 1.0);
  // The bias does not walk as the filter has it: the mean may be below 2, not above.
  EXPECT_LT(nees_sum / kSeeds, 2.0 + 3.3 * std::sqrt(4.0 / kSeeds));
  EXPECT_GT(nees_sum / kSeeds, 0.2);
}

TEST(TwoStageEkf, RecoversWhenTheBiasHasGone) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const TwoStageEkfParameters parameters;
    MatchedRobot robot = robot_of(parameters, seed);
    TwoStageEkf filter(parameters);
    settle(filter, robot);
    robot.run(filter, 30.0, kBias);
    robot.run(filter, 5.0);
    while (in_fault(filter) && robot.time < 120.0) robot.run(filter, 1.0);
    EXPECT_LT(robot.time, 120.0) << seed;
    EXPECT_LT(error(filter, robot).norm(), 0.8) << seed;
    EXPECT_LT(sigma(filter), 0.5) << seed;
    EXPECT_EQ(filter.estimate().bias, Eigen::Vector2d::Zero());
  }
}

TEST(TwoStageEkf, HoldsAFaultAsLongAsTheBias) {
  const TwoStageEkfParameters parameters;
  MatchedRobot robot = robot_of(parameters, 8);
  TwoStageEkf filter(parameters);
  settle(filter, robot);
  for (int i = 0; i < 100; ++i) {
    const double turned = 0.05 * i;
    robot.run(filter, 1.0, 6.0 * Eigen::Vector2d(std::cos(turned), std::sin(turned)));
    ASSERT_TRUE(in_fault(filter)) << i;
  }
  EXPECT_LT(error(filter, robot).norm(), 3.0 * std::sqrt(2.0) * sigma(filter));
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

TEST(TwoStageEkf, ASpikeMovesItLittleAndIsForgotten) {
  const TwoStageEkfParameters parameters;
  for (const double distance : {10.0, 300.0, 1e7}) {
    MatchedRobot robot = robot_of(parameters, 10);
    TwoStageEkf filter(parameters);
    settle(filter, robot);
    const Pose2 before = filter.estimate().pose;
    GnssFix spike = robot.fix();
    spike.position.x() += distance;
    EXPECT_GT(filter.update(spike).nis, 7.81);
    EXPECT_TRUE(in_fault(filter));
    EXPECT_LT((filter.estimate().pose.position() - before.position()).norm(), 0.3);
    robot.run(filter, 10.0);
    EXPECT_FALSE(in_fault(filter));
    EXPECT_LT(error(filter, robot).norm(), 0.6);
  }
}

/// A start that is wrong and sure of it makes every fix look faulty, but not for ever.
TEST(TwoStageEkf, FindsItsWayBackFromAWrongStart) {
  const TwoStageEkfParameters parameters;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    MatchedRobot robot = robot_of(parameters, seed);
    PosePrior wrong = prior_at({8.0, -6.0, 0.1});
    wrong.covariance.topLeftCorner<2, 2>() *= 0.2;
    TwoStageEkf filter(parameters);
    filter.start(wrong);
    robot.run(filter, 10.0);
    EXPECT_TRUE(in_fault(filter));
    while (in_fault(filter) && robot.time < 120.0) robot.run(filter, 1.0);
    EXPECT_LT(robot.time, 120.0) << seed;
    EXPECT_LT(error(filter, robot).norm(), 0.8) << seed;
  }
}

/// Fixes further off than any bias: the pose may be what is wrong, and says so.
TEST(TwoStageEkf, DoesNotHoldOnToItsPoseAgainstAnIncredibleBias) {
  const TwoStageEkfParameters parameters;
  const Eigen::Vector2d far(50.0, 30.0);
  MatchedRobot robot = robot_of(parameters, 19);
  TwoStageEkf filter(parameters);
  settle(filter, robot);
  robot.run(filter, 0.9 * parameters.reopen_after, far);
  EXPECT_LT(sigma(filter), 2.0);
  robot.run(filter, 0.2 * parameters.reopen_after, far);
  EXPECT_TRUE(in_fault(filter));
  EXPECT_GT(sigma(filter), 25.0);
  EXPECT_LT(nees(filter, robot), 5.99);
  EXPECT_LT((filter.estimate().bias - 0.5 * far).norm(), 5.0);
  robot.run(filter, 60.0);
  EXPECT_LT(error(filter, robot).norm(), 0.8);
}

TEST(TwoStageEkf, NeitherMovesNorGetsSurerParkedInABias) {
  const TwoStageEkfParameters parameters;
  MatchedRobot robot = robot_of(parameters, 11);
  TwoStageEkf filter(parameters);
  settle(filter, robot);
  robot.run(filter, 20.0, kBias);
  const Pose2 before = filter.estimate().pose;
  const double sigma_before = sigma(filter);
  robot.speed = 0.0;
  const Pose2 parked = robot.truth;
  for (int i = 1; i <= 3000; ++i) {
    RandomStream random(11, static_cast<std::uint32_t>(i), 7);
    GnssFix fix = robot.fix();
    filter.predict({robot.time + 0.2 * i, 0.2, 0.0, 0.0});
    fix.position = parked * robot.antenna + kBias + 0.5 * Eigen::Vector2d(random.normal(), random.normal());
    filter.update(fix);
  }
  EXPECT_TRUE(in_fault(filter));
  EXPECT_LT((filter.estimate().pose.position() - before.position()).norm(), 2.0 * sigma_before);
  EXPECT_GT(sigma(filter), 0.7 * sigma_before);
}

TEST(TwoStageEkf, FindsItsHeadingUnaided) {
  const TwoStageEkfParameters parameters;
  for (const double speed : {2.0, -1.5}) {
    MatchedRobot robot = robot_of(parameters, 12);
    robot.truth = {10.0, -20.0, 2.0};
    robot.speed = speed;
    TwoStageEkf filter(parameters);
    filter.start(std::nullopt);
    EXPECT_FALSE(filter.estimate().valid);
    EXPECT_TRUE(filter.hypotheses().empty());
    robot.run(filter, 0.6);
    EXPECT_TRUE(filter.estimate().valid);
    EXPECT_FALSE(filter.estimate().aligned);
    robot.run(filter, 40.0);
    EXPECT_TRUE(filter.estimate().aligned);
    EXPECT_LT(error(filter, robot).norm(), 0.6);
    EXPECT_LT(std::abs(angle_difference(filter.estimate().pose.yaw, robot.truth.yaw)), 0.1);
  }
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

/// Fixes of one moment, five times a second or fifty, tell the same.
TEST(TwoStageEkf, FixesOfOneMomentCountOnce) {
  std::vector<double> sigmas;
  for (const int every : {1, 10}) {
    TwoStageEkfParameters parameters;
    parameters.fault_threshold = 1e6;
    MatchedRobot robot = robot_of(parameters, 18);
    TwoStageEkf filter(parameters);
    filter.start(prior_at(robot.truth));
    for (int i = 1; i <= 1000; ++i) {
      filter.predict(robot.drive());
      if (i % every == 0) filter.update(robot.fix());
    }
    sigmas.push_back(sigma(filter));
  }
  EXPECT_NEAR(sigmas[0], sigmas[1], 0.02 * sigmas[1]);
}

TEST(TwoStageEkf, RefusesBadInputAndChangesNothing) {
  const TwoStageEkfParameters parameters;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MatchedRobot robot = robot_of(parameters, 14);
  TwoStageEkf filter(parameters);
  settle(filter, robot);
  const PoseEstimate before = filter.estimate();
  GnssFix fix = robot.fix();
  EXPECT_EQ(filter.update(fix).reason, Reason::kFrozen);
  fix.position.x() = nan;
  EXPECT_EQ(filter.update(fix).reason, Reason::kNotFinite);
  fix = robot.fix();
  fix.covariance(0, 0) = -1.0;
  EXPECT_EQ(filter.update(fix).reason, Reason::kInvalidCovariance);
  fix = robot.fix();
  fix.position.y() = 1e9;
  EXPECT_EQ(filter.update(fix).reason, Reason::kInvalidPosition);
  EXPECT_EQ(filter.update(DualAntennaFix{}).reason, Reason::kUnused);
  EXPECT_EQ(filter.update(PseudorangeEpoch{}).reason, Reason::kUnused);
  filter.predict({robot.time + 0.1, 0.1, nan, 0.0});
  filter.predict({robot.time + 0.1, 0.0, 1.0, 0.0});
  expect_same(filter.estimate(), before, kExactly);
  filter.start(prior_at({nan, 0.0, 0.0}));
  EXPECT_FALSE(filter.estimate().valid);
}

TEST(TwoStageEkf, IsTheSameEveryTimeAndAfterARestart) {
  const TwoStageEkfParameters parameters;
  TwoStageEkf used(parameters, 1);
  TwoStageEkf fresh(parameters, 2);
  MatchedRobot elsewhere = robot_of(parameters, 15);
  used.start(std::nullopt);
  elsewhere.run(used, 30.0);
  elsewhere.run(used, 10.0, kBias);
  ASSERT_TRUE(in_fault(used));
  for (TwoStageEkf* filter : {&used, &fresh}) {
    MatchedRobot robot = robot_of(parameters, 16);
    filter->start(std::nullopt);
    robot.run(*filter, 30.0);
    EXPECT_FALSE(in_fault(*filter));
    robot.run(*filter, 20.0, kBias);
  }
  expect_same(used.estimate(), fresh.estimate(), kExactly);
}

}  // namespace
}  // namespace multipath_localization
