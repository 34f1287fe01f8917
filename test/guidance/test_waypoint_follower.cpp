#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "driven.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {
namespace {

const std::vector<Eigen::Vector2d> kSquare = {{20.0, 0.0}, {20.0, 20.0}, {0.0, 20.0}, {0.0, 0.0}};

/// Drives by exact poses until finished or `duration` [s] is over; the largest distance from the line y = 0
/// after x = 10.
double largest_offset(WaypointFollower& follower, Pose2 pose, double wheelbase, double duration) {
  double largest = 0.0;
  for (double time = 0.0; time < duration && !follower.finished(); time += 0.02) {
    pose = driven(pose, follower.command(pose, 0.0, Trust::kGood).command, wheelbase, 0.02);
    if (pose.x > 10.0) largest = std::max(largest, std::abs(pose.y));
  }
  return largest;
}

class Law : public testing::TestWithParam<const char*> {
 protected:
  WaypointFollowerParameters parameters() const {
    WaypointFollowerParameters p;
    p.law = GetParam();
    return p;
  }
};

TEST_P(Law, DrivesLapAfterLapOnExactPoses) {
  WaypointFollower follower(parameters(), kSquare);
  Pose2 pose{0.0, 0.0, 0.0};
  for (double time = 0.0; time < 170.0; time += 0.02) {  // 255 m of 80 m a lap
    pose = driven(pose, follower.command(pose, 0.0, Trust::kGood).command, 0.5, 0.02);
    ASSERT_LT((pose.position() - Eigen::Vector2d(10.0, 10.0)).lpNorm<Eigen::Infinity>(), 12.0);
  }
  EXPECT_EQ(follower.route().rounds(), 3);
}

TEST_P(Law, FinishesWithoutLoop) {
  WaypointFollowerParameters p = parameters();
  p.loop = false;
  WaypointFollower follower(p, {{10.0, 0.0}, {20.0, 5.0}});
  largest_offset(follower, {0.0, 0.0, 0.0}, p.wheelbase, 60.0);
  EXPECT_TRUE(follower.finished());
  EXPECT_DOUBLE_EQ(follower.progress(), 1.0);
  const FollowerOutput output = follower.command({20.0, 5.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_EQ(output.status, "finished");
  EXPECT_EQ(output.command.speed, 0.0);
}

TEST_P(Law, TurnsRoundWhenHeadingTheWrongWay) {
  WaypointFollowerParameters p = parameters();
  p.loop = false;
  WaypointFollower follower(p, {{20.0, 0.0}});
  largest_offset(follower, {0.0, 0.0, 3.1}, p.wheelbase, 60.0);
  EXPECT_TRUE(follower.finished());
}

TEST_P(Law, SteersWithinTheLimit) {
  WaypointFollower follower(parameters(), {{20.0, 0.0}});
  for (double yaw = -3.0; yaw < 3.1; yaw += 0.1) {
    const MotionCommand u = follower.command({0.0, 0.0, yaw}, 0.0, Trust::kGood).command;
    EXPECT_LE(std::abs(u.steering_angle), parameters().max_steering_angle);
  }
}

TEST(WaypointFollower, PathTrackingComesBackToTheLine) {
  WaypointFollowerParameters p;
  WaypointFollower follower(p, {{0.0, 0.0}, {60.0, 0.0}});
  follower.command({0.0, 0.0, 0.0}, 0.0, Trust::kGood);  // passes the first: the line is y = 0
  ASSERT_EQ(follower.target(), 1U);
  EXPECT_LT(largest_offset(follower, {0.0, 2.0, 0.0}, p.wheelbase, 35.0), 0.05);
}

TEST(WaypointFollower, NishidaSteersByTheHeadingErrorTimesItsGain) {  // Eqs. (36) and (38) of [NIS]
  WaypointFollowerParameters p;
  p.law = "nishida";
  WaypointFollower follower(p, {{10.0, 10.0}});
  const MotionCommand u = follower.command({0.0, 0.0, 0.5}, 0.0, Trust::kGood).command;
  EXPECT_NEAR(u.steering_angle, 0.8 * (0.25 * kPi - 0.5), 1e-12);
  EXPECT_EQ(u.speed, p.cruise_speed);
}

TEST(WaypointFollower, NishidaTakesTheSmallestTurnAcrossPi) {
  WaypointFollowerParameters p;
  p.law = "nishida";
  WaypointFollower follower(p, {{-10.0, -1.0}});
  const MotionCommand u = follower.command({0.0, 0.0, 3.0}, 0.0, Trust::kGood).command;
  EXPECT_NEAR(u.steering_angle, 0.8 * (std::atan2(-1.0, -10.0) + 2.0 * kPi - 3.0), 1e-12);
}

TEST(WaypointFollower, PassesByRadius) {
  WaypointFollower follower(WaypointFollowerParameters{}, kSquare);
  follower.command({0.0, 10.0, 0.0}, 0.0, Trust::kGood);
  follower.command({18.9, 0.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_EQ(follower.target(), 0U);
  follower.command({19.1, 0.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_EQ(follower.target(), 1U);
}

TEST(WaypointFollower, PassesByCrossingTheLineOfAMissedWaypoint) {
  WaypointFollower follower(WaypointFollowerParameters{}, {{20.0, 0.0}, {40.0, 0.0}});
  follower.command({0.0, 0.0, 0.0}, 0.0, Trust::kGood);
  follower.command({19.9, 3.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_EQ(follower.target(), 0U);
  follower.command({20.1, 6.0, 0.0}, 0.0, Trust::kGood);  // too far aside
  EXPECT_EQ(follower.target(), 0U);
  follower.command({20.1, 3.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_EQ(follower.target(), 1U);
}

TEST(WaypointFollower, CountsLapsAndProgress) {
  WaypointFollower follower(WaypointFollowerParameters{}, kSquare);
  EXPECT_EQ(follower.progress(), 0.0);
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector2d& at = kSquare[static_cast<std::size_t>(i) % 4];
    follower.command({at.x(), at.y(), 0.0}, 0.0, Trust::kGood);
  }
  EXPECT_EQ(follower.route().rounds(), 1);
  EXPECT_DOUBLE_EQ(follower.progress(), 1.5);
  EXPECT_EQ(follower.target(), 2U);
  EXPECT_FALSE(follower.finished());
}

INSTANTIATE_TEST_SUITE_P(WaypointFollower, Law, testing::Values("nishida", "path_tracking"));

TEST(WaypointFollower, StopsAndSaysWhy) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  WaypointFollower follower(WaypointFollowerParameters{}, kSquare);
  const auto stop = [&](const Pose2& pose, double age, Trust state) {
    const FollowerOutput output = follower.command(pose, age, state);
    EXPECT_EQ(output.command.speed, 0.0) << output.status;
    EXPECT_EQ(output.command.steering_angle, 0.0) << output.status;
    EXPECT_TRUE(output.urgent) << output.status;
    return output.status;
  };
  EXPECT_EQ(stop({}, 1.2, Trust::kGood), "stopped: pose is 1.2 s old");
  EXPECT_EQ(stop({}, -4.0, Trust::kGood), "stopped: pose is 4.0 s ahead");
  EXPECT_EQ(stop({}, nan, Trust::kGood), "stopped: no pose yet");
  EXPECT_EQ(stop({nan, 0.0, 0.0}, 0.0, Trust::kGood), "stopped: pose not finite");
  EXPECT_EQ(follower.command({}, 0.0, Trust::kGood, nan).status, "stopped: pose not finite");
  EXPECT_EQ(stop({}, 0.0, Trust::kNotReady), "stopped: localisation not ready");
  EXPECT_EQ(stop({}, 0.0, Trust::kLost), "stopped: localisation lost");
  EXPECT_EQ(follower.command({}, 0.0, Trust::kGood).status, "driving");
  WaypointFollower idle(WaypointFollowerParameters{}, {});
  EXPECT_EQ(idle.command({}, 0.0, Trust::kGood).status, "stopped: no waypoints");
}

TEST(WaypointFollower, SlowsByTheStandardDeviationAndSaysWhy) {
  WaypointFollowerParameters p;
  p.cruise_speed = 2.0;
  p.slow_sigma = 1.0;
  p.stop_sigma = 3.0;
  WaypointFollower follower(p, kSquare);
  const auto at = [&](double sigma, Trust state) { return follower.command({}, 0.0, state, sigma); };
  for (const Trust state : {Trust::kGood, Trust::kMultipath, Trust::kDeadReckoning}) {
    EXPECT_EQ(at(1.0, state).command.speed, 2.0);
    EXPECT_EQ(at(1.0, state).status, "driving");
    EXPECT_DOUBLE_EQ(at(1.5, state).command.speed, 1.5);
    EXPECT_DOUBLE_EQ(at(2.5, state).command.speed, 0.5);
    EXPECT_EQ(at(3.0, state).command.speed, 0.0);
  }
  EXPECT_EQ(at(2.0, Trust::kGood).status, "slow: position uncertain");
  EXPECT_EQ(at(2.0, Trust::kMultipath).status, "slow: fixes are biased");
  EXPECT_EQ(at(2.0, Trust::kDeadReckoning).status, "slow: no usable fix");
  EXPECT_EQ(at(5.0, Trust::kDeadReckoning).status, "stopped: no usable fix");
  EXPECT_EQ(at(5.0, Trust::kAligning).status, "slow: heading not yet confirmed");
  EXPECT_FALSE(at(5.0, Trust::kGood).urgent);
}

TEST(WaypointFollower, StopsAsOneStepWhereTheTwoDeviationsAreOne) {
  WaypointFollowerParameters p;
  p.slow_sigma = p.stop_sigma = 2.0;
  WaypointFollower follower(p, kSquare);
  EXPECT_EQ(follower.command({}, 0.0, Trust::kGood, 1.9).command.speed, p.cruise_speed);
  EXPECT_EQ(follower.command({}, 0.0, Trust::kGood, 2.1).command.speed, 0.0);
}

TEST(WaypointFollower, StopsFarOffItsPathWithTheReason) {
  WaypointFollowerParameters p;
  p.max_deviation = 1.5;
  WaypointFollower follower(p, kSquare);
  follower.command({0.0, 0.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_EQ(follower.command({5.0, 1.4, 0.0}, 0.0, Trust::kGood).status, "driving");
  const FollowerOutput off = follower.command({5.0, 1.6, 0.0}, 0.0, Trust::kGood);
  EXPECT_EQ(off.status, "stopped: 1.6 m off the path");
  EXPECT_EQ(off.command.speed, 0.0);
  EXPECT_TRUE(off.urgent);
  EXPECT_EQ(follower.command({5.0, 1.4, 0.0}, 0.0, Trust::kGood).status, "driving");
}

TEST(WaypointFollower, StartsStraightUntilTheHeadingWasConfirmed) {
  WaypointFollower follower(WaypointFollowerParameters{}, kSquare);
  const Pose2 beside{19.5, 0.0, 2.0};
  const FollowerOutput first = follower.command(beside, 0.0, Trust::kAligning);
  EXPECT_EQ(first.command.steering_angle, 0.0);
  EXPECT_GT(first.command.speed, 0.0);
  EXPECT_EQ(follower.target(), 0U);  // a pose like this passes nothing
  follower.command(beside, 0.0, Trust::kGood);
  EXPECT_EQ(follower.target(), 1U);
  EXPECT_NE(follower.command(beside, 0.0, Trust::kAligning).command.steering_angle, 0.0);
}

TEST(WaypointFollower, StartsStraightForAtMostTheAligningDistance) {
  WaypointFollowerParameters p;
  p.aligning_distance = 3.0;
  WaypointFollower follower(p, kSquare);
  follower.command({0.0, 0.0, 0.5}, 0.0, Trust::kAligning);
  EXPECT_EQ(follower.command({2.9, 0.0, 0.5}, 0.0, Trust::kAligning).command.steering_angle, 0.0);
  EXPECT_NE(follower.command({3.1, 0.0, 0.5}, 0.0, Trust::kAligning).command.steering_angle, 0.0);
}

TEST(WaypointFollower, GoesStraightAgainAfterTheHeadingWasLost) {
  for (const Trust unknown : {Trust::kNotReady, Trust::kLost}) {
    WaypointFollower follower(WaypointFollowerParameters{}, kSquare);
    follower.command({0.0, 0.0, 0.0}, 0.0, Trust::kGood);
    EXPECT_NE(follower.command({3.0, 0.0, 2.0}, 0.0, Trust::kAligning).command.steering_angle, 0.0);
    follower.command({3.0, 0.0, 2.0}, 1e3, unknown);  // the pose has ceased besides
    for (const double x : {10.0, 14.9}) {
      const MotionCommand u = follower.command({x, 0.0, 2.0}, 0.0, Trust::kAligning).command;
      EXPECT_EQ(u.steering_angle, 0.0) << to_string(unknown);
      EXPECT_GT(u.speed, 0.0);
    }
    EXPECT_NE(follower.command({15.1, 0.0, 2.0}, 0.0, Trust::kAligning).command.steering_angle, 0.0);
  }
}

TEST(WaypointFollower, SteersOnInAligningAfterASkip) {
  WaypointFollower follower(WaypointFollowerParameters{}, kSquare);
  follower.command({0.0, 0.0, 0.0}, 0.0, Trust::kGood);
  follower.skip();
  EXPECT_NE(follower.command({0.0, 0.0, 0.0}, 0.0, Trust::kAligning).command.steering_angle, 0.0);
}

TEST(WaypointFollower, CountsTheAligningDistanceInOneMap) {
  WaypointFollower follower(WaypointFollowerParameters{}, {{20.0, 0.0}});
  follower.command({0.0, 0.0, 2.0}, 0.0, Trust::kAligning);
  follower.move_waypoints({{70.0, 0.0}});
  EXPECT_EQ(follower.command({50.0, 0.0, 2.0}, 0.0, Trust::kAligning).command.steering_angle, 0.0);
}

TEST(WaypointFollower, RefusesAWaypointThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(WaypointFollower(WaypointFollowerParameters{}, {{0.0, nan}}), std::invalid_argument);
}

}  // namespace
}  // namespace multipath_localization
