#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "estimators/ekf/chord_alignment.hpp"
#include "matched_robot.hpp"

namespace multipath_localization {
namespace {

/// Drives until the heading is found, at most for `longest` seconds.
void align(ChordAlignment& alignment, MatchedRobot& robot, double longest) {
  for (int step = 1; !alignment.aligned() && robot.time < longest; ++step) {
    alignment.predict(robot.drive());
    if (step % MatchedRobot::kStepsPerFix != 0) continue;
    const GnssFix fix = robot.fix();
    alignment.update(fix, fix.covariance);
  }
}

TEST(ChordAlignment, FindsTheStateAndKnowsHowWell) {
  constexpr int kSeeds = 60;
  const OdometryNoise noise;
  double nees_sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    MatchedRobot robot(noise, seed);
    robot.truth = {10.0, -20.0, 2.0};
    robot.speed = seed % 2 == 0 ? 2.0 : -2.0;
    ChordAlignment alignment({}, noise);
    align(alignment, robot, 20.0);
    ASSERT_TRUE(alignment.aligned());
    const Pose2 found = odometry_state::pose(alignment.state().mean);
    const Eigen::Vector3d error(found.x - robot.truth.x, found.y - robot.truth.y,
                                angle_difference(found.yaw, robot.truth.yaw));
    const Eigen::Matrix3d P = alignment.state().covariance.topLeftCorner<3, 3>();
    nees_sum += error.dot(P.inverse() * error);
  }
  // 3.3 standard deviations of a mean of chi-squares: sqrt(2 dof / count).
  EXPECT_NEAR(nees_sum / kSeeds, 3.0, 3.3 * std::sqrt(6.0 / kSeeds));
}

TEST(ChordAlignment, HasNothingBeforeTheFirstFixAndNoHeadingBeforeTheChordIsLong) {
  const OdometryNoise noise;
  MatchedRobot robot(noise, 2);
  robot.fix_sigma = 0.1;
  ChordAlignment alignment({}, noise);
  alignment.predict(robot.drive());
  EXPECT_FALSE(alignment.started());
  GnssFix fix = robot.fix();
  EXPECT_EQ(alignment.update(fix, fix.covariance).nis, 0.0);
  EXPECT_TRUE(alignment.started());
  EXPECT_NEAR(alignment.missing(), 5.0, 1e-9);
  align(alignment, robot, 2.2);  // 4.4 m
  EXPECT_FALSE(alignment.aligned());
  EXPECT_NEAR(alignment.missing(), 0.6, 0.5);
  align(alignment, robot, 3.2);
  EXPECT_TRUE(alignment.aligned());
}

TEST(ChordAlignment, AFixThatJumpsGivesNoHeading) {
  const OdometryNoise noise;
  MatchedRobot robot(noise, 3);
  ChordAlignment alignment({}, noise);
  align(alignment, robot, 2.0);
  for (int step = 0; step < 100; ++step) alignment.predict(robot.drive());
  GnssFix spike = robot.fix();
  spike.position.x() += 30.0;
  alignment.update(spike, spike.covariance);
  EXPECT_FALSE(alignment.aligned());
}

TEST(ChordAlignment, TakesThePriorAtItsWord) {
  const OdometryNoise noise;
  ChordAlignment alignment({}, noise);
  PosePrior prior = prior_at({3.0, 4.0, 0.5});
  alignment.start(prior);
  EXPECT_TRUE(alignment.aligned());
  EXPECT_EQ(alignment.state().covariance(2, 2), 0.01);
  prior.covariance(2, 2) = 1.5;
  alignment.start(prior);
  EXPECT_TRUE(alignment.started());
  EXPECT_FALSE(alignment.aligned());
  prior.pose.x = std::nan("");
  alignment.start(prior);
  EXPECT_FALSE(alignment.started());
}

TEST(ChordAlignment, StandsStillWithTheWheels) {
  const OdometryNoise noise;
  ChordAlignment alignment({}, noise);
  PosePrior prior = prior_at({3.0, 4.0, 0.5});
  prior.covariance(2, 2) = 1.5;
  alignment.start(prior);
  for (int i = 1; i < 1000; ++i) alignment.predict({0.02 * i, 0.02, 0.0, 0.0});
  EXPECT_EQ(alignment.state().covariance(0, 0), 0.25);
}

TEST(ChordAlignment, TimeParkedMakesTheHeadingNoWorse) {
  const OdometryNoise noise;
  std::vector<odometry_state::Matrix> covariances;
  for (const double parked : {0.0, 200.0 * kPi}) {  // whole turns of the winding road
    MatchedRobot robot(noise, 4);
    ChordAlignment alignment({}, noise);
    align(alignment, robot, 0.2);  // until the first fix
    alignment.predict({robot.time + parked, parked + 0.02, 0.0, 0.0});
    robot.time += parked;
    align(alignment, robot, parked + 20.0);
    ASSERT_TRUE(alignment.aligned());
    covariances.push_back(alignment.state().covariance);
  }
  EXPECT_NEAR(covariances[1](2, 2), covariances[0](2, 2), 0.1 * covariances[0](2, 2));
}

}  // namespace
}  // namespace multipath_localization
