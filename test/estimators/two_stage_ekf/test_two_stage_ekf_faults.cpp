#include <gtest/gtest.h>

#include <cmath>

#include "estimators/two_stage_ekf/two_stage_ekf.hpp"
#include "matched_robot.hpp"
#include "multipath_localization/core/random.hpp"
#include "two_stage_robot.hpp"

namespace multipath_localization {
namespace {

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

}  // namespace
}  // namespace multipath_localization
