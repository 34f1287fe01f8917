#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "estimators/gated_ekf/gated_ekf.hpp"
#include "matched_robot.hpp"

namespace multipath_localization {
namespace {

Eigen::Vector3d pose_error(const PoseEstimate& estimate, const Pose2& truth) {
  return {estimate.pose.x - truth.x, estimate.pose.y - truth.y,
          angle_difference(estimate.pose.yaw, truth.yaw)};
}

double distance(const PoseEstimate& estimate, const Pose2& truth) {
  return pose_error(estimate, truth).head<2>().norm();
}

double nees(const PoseEstimate& estimate, const Pose2& truth) {
  const Eigen::Vector3d error = pose_error(estimate, truth);
  return error.dot(estimate.covariance.inverse() * error);
}

TEST(GatedEkf, NeesAndNisLieInTheirChiSquareBands) {
  constexpr int kSeeds = 80;
  GatedEkfParameters parameters;
  parameters.gate = 1e6;
  double nees_sum = 0.0;
  double nis_sum = 0.0;
  int fixes = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    MatchedRobot robot(parameters.odometry, seed);
    RandomStream random(seed, 0, 3);
    const Pose2 start{0.5 * random.normal(), 0.5 * random.normal(), 0.1 * random.normal()};
    GatedEkf filter(parameters);
    filter.start(prior_at(start));
    for (; fixes < 150 * static_cast<int>(seed); ++fixes) {
      robot.run(filter, MatchedRobot::kStep * MatchedRobot::kStepsPerFix);
      nis_sum += robot.last.nis;
    }
    nees_sum += nees(filter.estimate(), robot.truth);
  }
  // 3.3 standard deviations of a mean of chi-squares: sqrt(2 dof / count).
  EXPECT_NEAR(nees_sum / kSeeds, 3.0, 3.3 * std::sqrt(6.0 / kSeeds));
  EXPECT_NEAR(nis_sum / fixes, 2.0, 3.3 * std::sqrt(4.0 / fixes));
}

TEST(GatedEkf, FindsItsHeadingFromTheChordAndKnowsHowWell) {
  constexpr int kSeeds = 60;
  const GatedEkfParameters parameters;
  double nees_sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    MatchedRobot robot(parameters.odometry, seed);
    robot.truth = {10.0, -20.0, 2.0};
    GatedEkf filter(parameters);
    filter.start(std::nullopt);
    while (!filter.estimate().aligned && robot.time < 20.0) robot.run(filter, 0.2);
    ASSERT_LT(robot.time, 5.0);  // 5 m at 2 m/s, plus noise
    nees_sum += nees(filter.estimate(), robot.truth);
  }
  EXPECT_NEAR(nees_sum / kSeeds, 3.0, 3.3 * std::sqrt(6.0 / kSeeds));
}

TEST(GatedEkf, FindsItsHeadingInReverse) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters.odometry, 7);
  robot.truth = {0.0, 0.0, -2.5};
  robot.speed = -1.5;
  GatedEkf filter(parameters);
  filter.start(std::nullopt);
  robot.run(filter, 30.0);
  ASSERT_TRUE(filter.estimate().aligned);
  EXPECT_LT(std::abs(angle_difference(filter.estimate().pose.yaw, robot.truth.yaw)), 0.1);
  EXPECT_LT(distance(filter.estimate(), robot.truth), 0.6);
}

TEST(GatedEkf, FollowsTheFixesBeforeItIsAligned) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters.odometry, 8);
  GatedEkf filter(parameters);
  filter.start(std::nullopt);
  filter.predict(robot.drive());
  EXPECT_FALSE(filter.estimate().valid);
  EXPECT_TRUE(filter.hypotheses().empty());
  robot.run(filter, 0.6);
  const PoseEstimate estimate = filter.estimate();
  EXPECT_TRUE(estimate.valid);
  EXPECT_FALSE(estimate.aligned);
  EXPECT_GT(estimate.covariance(2, 2), 3.0);
  EXPECT_LT(distance(estimate, robot.truth), 2.0);
  EXPECT_EQ(filter.hypotheses().size(), 1U);
}

TEST(GatedEkf, RefusesASpikeAndKeepsItsPose) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters.odometry, 9);
  GatedEkf filter(parameters);
  filter.start(prior_at(robot.truth));
  robot.run(filter, 20.0);
  const PoseEstimate before = filter.estimate();
  GnssFix spike = robot.fix();
  spike.position += Eigen::Vector2d(15.0, 0.0);
  const Innovation result = filter.update(spike);
  EXPECT_EQ(result.reason, Reason::kGated);
  EXPECT_GT(result.nis, parameters.gate);
  EXPECT_NEAR(result.innovation.x(), 15.0, 3.0);
  EXPECT_EQ(filter.estimate().pose.x, before.pose.x);
  EXPECT_EQ(filter.estimate().covariance, before.covariance);
}

TEST(GatedEkf, AcceptsAnOffsetThatPersists) {
  const GatedEkfParameters parameters;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    MatchedRobot robot(parameters.odometry, seed);
    GatedEkf filter(parameters);
    filter.start(prior_at(robot.truth));
    robot.run(filter, 20.0);
    const Eigen::Vector2d offset(16.0, -12.0);
    robot.run(filter, parameters.reopen_after - 0.4, offset);
    EXPECT_EQ(robot.last.reason, Reason::kGated);
    EXPECT_LT(distance(filter.estimate(), robot.truth), 3.0);
    robot.run(filter, 1.0, offset);
    EXPECT_EQ(robot.last.reason, Reason::kAccepted);
    const Pose2 seen{robot.truth.x + offset.x(), robot.truth.y + offset.y(), robot.truth.yaw};
    EXPECT_LT(distance(filter.estimate(), seen), 3.0);
  }
}

TEST(GatedEkf, AcceptsAnOffsetThatPersistsInFixesFarApart) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters.odometry, 10);
  GatedEkf filter(parameters);
  filter.start(prior_at(robot.truth));
  robot.run(filter, 20.0);
  bool taken = false;
  for (int fix = 0; fix < 5 && !taken; ++fix) {
    const double until = robot.time + 3.0;
    while (robot.time < until) filter.predict(robot.drive());
    GnssFix moved = robot.fix();
    moved.position += Eigen::Vector2d(16.0, -12.0);
    taken = filter.update(moved).accepted();
    EXPECT_FALSE(taken && fix < 2) << "an outlier or two";
  }
  EXPECT_TRUE(taken);
}

TEST(GatedEkf, AnOutageIsNoRejection) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters.odometry, 11);
  GatedEkf filter(parameters);
  filter.start(prior_at(robot.truth));
  robot.run(filter, 20.0);
  for (int i = 0; i < 500; ++i) filter.predict(robot.drive());
  GnssFix spike = robot.fix();
  spike.position.x() += 50.0;
  EXPECT_EQ(filter.update(spike).reason, Reason::kGated);
  EXPECT_EQ(filter.update(robot.fix()).reason, Reason::kAccepted);
}

TEST(GatedEkf, LeverArmOfALateFixCounts) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters.odometry, 12);
  robot.antenna = {-6.0, 1.0};
  GatedEkf filter(parameters);
  filter.start(std::nullopt);
  robot.run(filter, 40.0);
  EXPECT_TRUE(filter.estimate().aligned);
  EXPECT_LT(distance(filter.estimate(), robot.truth), 0.8);
}

TEST(GatedEkf, ParkedRobotNeitherDiffusesNorTurns) {
  const GatedEkfParameters parameters;
  MatchedRobot robot(parameters.odometry, 13);
  GatedEkf filter(parameters);
  filter.start(prior_at(robot.truth));
  robot.run(filter, 10.0);
  const PoseEstimate before = filter.estimate();
  for (int i = 0; i < 3000; ++i)
    filter.predict({robot.time + MatchedRobot::kStep * i, MatchedRobot::kStep, 0.0, 0.0});
  EXPECT_EQ(filter.estimate().covariance, before.covariance);
  EXPECT_EQ(filter.estimate().pose.yaw, before.pose.yaw);
}

TEST(GatedEkf, WidePriorHeadingCountsAsUnknown) {
  PosePrior prior = prior_at({3.0, 4.0, 0.5});
  prior.covariance(2, 2) = 10.0;
  GatedEkf filter{GatedEkfParameters{}};
  filter.start(prior);
  EXPECT_TRUE(filter.estimate().valid);
  EXPECT_FALSE(filter.estimate().aligned);
  EXPECT_EQ(filter.estimate().pose.x, 3.0);
}

TEST(GatedEkf, UnusablePriorsAndIncrementsChangeNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  GatedEkf filter{GatedEkfParameters{}};
  filter.start(prior_at({nan, 0.0, 0.0}));
  EXPECT_FALSE(filter.estimate().valid);
  filter.start(prior_at({1.0, 2.0, 0.5}));
  for (const OdometryIncrement& u :
       {OdometryIncrement{0.1, 0.1, nan, 0.0}, OdometryIncrement{0.1, 0.0, 1.0, 0.0},
        OdometryIncrement{0.1, -1.0, 1.0, 0.0}}) {
    filter.predict(u);
    EXPECT_EQ(filter.estimate().pose.x, 1.0);
  }
}

}  // namespace
}  // namespace multipath_localization
