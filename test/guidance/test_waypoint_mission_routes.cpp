#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "driven.hpp"
#include "missions.hpp"
#include "multipath_localization/guidance/waypoint_mission.hpp"

namespace multipath_localization {
namespace {

TEST(WaypointMission, NewWaypointsDoNotUndoAPauseOrAStop) {
  WaypointMission robot = mission();
  robot.pause();
  robot.set_waypoints(kLine);
  expect_standing(robot, "paused: waiting for resume");
  robot.stop();
  robot.set_waypoints(kLine);
  expect_standing(robot, "stopped: by order, waiting for start");
}

TEST(WaypointMission, NewWaypointsAreDrivenWhenFinished) {
  WaypointMission robot = mission(false);
  drive_to_the_end(robot);
  robot.set_waypoints(kLine);
  EXPECT_GT(at(robot, 0.0).command.speed, 0.0);
}

TEST(WaypointMission, TheSameWaypointsDeliveredAgainDoNotRestartTheWay) {
  WaypointMission robot({}, {}, true);
  EXPECT_EQ(robot.offer_waypoints(kLine, 5), Delivery::kNew);
  at(robot, 0.0);
  at(robot, 10.0);
  for (const std::uint64_t stamp : {5U, 0U, 6U, 7U}) {
    EXPECT_NE(robot.offer_waypoints(kLine, stamp), Delivery::kNew);
    EXPECT_EQ(robot.follower().target(), 1U);
  }
  EXPECT_EQ(robot.offer_waypoints({{10.0, 5.0}, {20.0, 1.0}, {30.0, 0.0}}, 7), Delivery::kNew);
  EXPECT_EQ(robot.follower().target(), 0U);
}

TEST(WaypointMission, GoesOnAlongARouteRemadeGrownOrShortened) {
  WaypointMission robot({}, {}, true);
  robot.offer_waypoints(kLine, 1);
  at(robot, 0.0);
  at(robot, 10.0);
  EXPECT_EQ(robot.offer_waypoints({{10.0, 1e-7}, {20.0, -0.01}, {30.0, 0.0}}, 2), Delivery::kContinued);
  EXPECT_EQ(robot.follower().target(), 1U);
  EXPECT_EQ(robot.follower().waypoints()[1].y(), -0.01) << "to where they are now";
  EXPECT_EQ(robot.offer_waypoints({{10.0, 0.0}, {20.0, 0.0}, {30.0, 0.0}, {30.0, 9.0}}, 3),
            Delivery::kContinued);
  EXPECT_EQ(robot.follower().target(), 1U);
  EXPECT_EQ(robot.offer_waypoints({{20.0, 0.0}, {30.0, 0.0}, {30.0, 9.0}}, 4), Delivery::kContinued);
  EXPECT_EQ(robot.follower().target(), 0U);
  const FollowerOutput output = robot.command({15.0, 1.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_LT(output.command.steering_angle, -0.1) << "back to the line it was on";
}

/// What a planner makes from a place to the goal: a waypoint each half metre, never twice the same way.
std::vector<Eigen::Vector2d> planned(const Eigen::Vector2d& from, const Eigen::Vector2d& goal, int plan) {
  const Eigen::Vector2d way = goal - from, aside(-way.y(), way.x());
  const auto steps = static_cast<int>(way.norm() / 0.5) + 1;
  std::vector<Eigen::Vector2d> waypoints;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    waypoints.emplace_back(from + share * way +
                           (plan % 2 == 0 ? 0.02 : -0.02) * std::sin(kPi * share) * aside);
  }
  return waypoints;
}

TEST(WaypointMission, JoinsAPathPlannedAMomentAgoWhereTheRobotIsOnIt) {
  constexpr double kStep = 0.02;
  const Eigen::Vector2d goal(30.0, 5.0);
  for (const double lateness : {0.2, 1.0, 2.0}) {
    WaypointFollowerParameters p;
    p.loop = false;
    WaypointMission robot(p, {}, true);
    std::vector<Pose2> driven_way = {{0.0, 0.0, 0.1}};
    const auto late = static_cast<std::size_t>(lateness / kStep);
    double furthest_turn = 0.0;
    for (int i = 0; i < 1500 && !robot.stands(); ++i) {
      const Pose2 now = driven_way.back();
      if (i % 50 == 0) {
        const Pose2& then = driven_way[driven_way.size() - std::min(late + 1, driven_way.size())];
        robot.offer_waypoints(planned(then.position(), goal, i / 50), static_cast<std::uint64_t>(i + 1));
      }
      const MotionCommand u = robot.command(now, 0.0, Trust::kGood).command;
      driven_way.push_back(driven(now, u, p.wheelbase, kStep));
      furthest_turn = std::max(furthest_turn, std::abs(driven_way.back().yaw));
    }
    EXPECT_TRUE(robot.stands()) << lateness;
    EXPECT_LT((driven_way.back().position() - goal).norm(), 1.2) << lateness;
    EXPECT_LT(furthest_turn, 0.6) << lateness;
  }
}

TEST(WaypointMission, DrivesARouteThatBeginsElsewhereFromItsFirstWaypoint) {
  WaypointMission robot({}, kLine, true);
  for (const double x : {0.0, 2.0, 4.0, 6.0, 8.0}) at(robot, x);
  robot.offer_waypoints({{-20.0, 0.0}, {20.0, 0.0}, {30.0, 0.0}}, 1);
  EXPECT_EQ(robot.follower().target(), 0U) << "though it stands on the way to the second";
  robot.offer_waypoints({{6.0, 0.0}, {-20.0, 0.0}}, 2);
  EXPECT_EQ(robot.follower().target(), 1U) << "back, as told, from where it has just been";
}

TEST(WaypointMission, ARouteShortenedToWhatIsLeftInALaterRoundIsNotYetFinished) {
  WaypointMission robot({}, {}, true);
  robot.offer_waypoints(kLine, 1);
  drive_to_the_end(robot);
  at(robot, 10.0);
  at(robot, 20.0);
  EXPECT_EQ(robot.offer_waypoints({{30.0, 0.0}}, 2), Delivery::kContinued);
  EXPECT_GT(at(robot, 22.0).command.speed, 0.0);
  EXPECT_EQ(at(robot, 30.0).command.speed, 0.0);
}

TEST(WaypointMission, AFinishedRobotGoesOnToWhatIsAddedBehind) {
  WaypointMission robot({}, {{10.0, 0.0}}, true);
  at(robot, 0.0);
  EXPECT_EQ(at(robot, 10.0).command.speed, 0.0);
  EXPECT_EQ(robot.offer_waypoints({{10.0, 0.0}, {10.0, 20.0}}, 1), Delivery::kContinued);
  EXPECT_EQ(robot.follower().target(), 1U);
  const MotionCommand u = robot.command({10.0, 5.0, 0.5 * kPi}, 0.0, Trust::kGood).command;
  EXPECT_GT(u.speed, 0.0);
  EXPECT_NEAR(u.steering_angle, 0.0, 1e-9) << "along the line from the waypoint it was at";
}

TEST(WaypointMission, StopsAtOnceWhenEmptied) {
  WaypointMission robot = mission();
  at(robot, 0.0);
  EXPECT_EQ(robot.offer_waypoints({}, 1), Delivery::kNew);
  expect_standing(robot, "stopped: no waypoints");
  EXPECT_EQ(robot.offer_waypoints(kLine, 1), Delivery::kNew);
}

TEST(WaypointMission, SaysThatASmallRouteIsNotDrivenRound) {
  WaypointMission robot({}, {{10.0, 0.0}}, true);
  EXPECT_NE(robot.set_loop(true).message.find("not on this route"), std::string::npos);
  EXPECT_EQ(mission().set_loop(true).message, "goes on to the first waypoint after the last");
}

TEST(WaypointMission, OnlyALaterStampHasAFinishedRobotDriveTheSameWaypointsAnew) {
  WaypointMission robot = mission(false);
  EXPECT_EQ(robot.offer_waypoints(kLine, 5), Delivery::kContinued) << "it was started with them";
  drive_to_the_end(robot);
  for (const std::uint64_t stamp : {5U, 0U, 4U}) {
    EXPECT_EQ(robot.offer_waypoints(kLine, stamp), Delivery::kKnown);
    expect_standing(robot, "finished");
  }
  EXPECT_EQ(robot.offer_waypoints(kLine, 6), Delivery::kNew);
  EXPECT_GT(at(robot, 0.0).command.speed, 0.0);
}

TEST(WaypointMission, WaypointsWithoutAStampAreOneDeliveryUntilOthersCome) {
  WaypointMission robot = mission(false);
  robot.offer_waypoints(kLine, 0);
  drive_to_the_end(robot);
  EXPECT_EQ(robot.offer_waypoints(kLine, 0), Delivery::kKnown);
  expect_standing(robot, "finished");
  EXPECT_EQ(robot.offer_waypoints({{5.0, 0.0}}, 0), Delivery::kNew);
  EXPECT_EQ(robot.offer_waypoints(kLine, 0), Delivery::kNew);
}

TEST(WaypointMission, WaypointsDeliveredAgainStayWhereTheyAreThoughMapHasMoved) {
  WaypointMission robot({}, {}, true);
  robot.offer_waypoints(kLine, 5);
  robot.move_waypoints({{10.0, 5.0}, {20.0, 5.0}, {30.0, 5.0}});
  EXPECT_EQ(robot.offer_waypoints(kLine, 5), Delivery::kKnown);
  EXPECT_EQ(robot.follower().waypoints()[0], Eigen::Vector2d(10.0, 5.0));
  EXPECT_EQ(robot.offer_waypoints(kLine, 6), Delivery::kNew) << "in the new map they are others";
}

}  // namespace
}  // namespace multipath_localization
