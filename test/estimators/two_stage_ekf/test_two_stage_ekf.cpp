#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "estimators/two_stage_ekf/two_stage_ekf.hpp"
#include "matched_robot.hpp"
#include "two_stage_robot.hpp"

namespace multipath_localization {
namespace {

constexpr double kExactly = 1e-300;

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
