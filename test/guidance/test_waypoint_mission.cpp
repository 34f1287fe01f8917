#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "driven.hpp"
#include "missions.hpp"
#include "multipath_localization/guidance/waypoint_mission.hpp"

namespace multipath_localization {
namespace {

TEST(WaypointMission, DrivesAtOnceUnlessToldToWaitForStart) {
  WaypointMission at_once = mission();
  EXPECT_GT(at(at_once, 0.0).command.speed, 0.0);
  WaypointMission waits = mission(true, false);
  expect_standing(waits, "stopped: waiting for start");
  EXPECT_FALSE(waits.resume().done);
  EXPECT_TRUE(waits.start().done);
  EXPECT_GT(at(waits, 0.0).command.speed, 0.0);
}

TEST(WaypointMission, PauseKeepsTheWaypointAndStopForgetsIt) {
  WaypointMission robot = mission();
  at(robot, 0.0);
  at(robot, 10.0);
  ASSERT_EQ(robot.follower().target(), 1U);
  EXPECT_TRUE(robot.pause().done);
  expect_standing(robot, "paused: waiting for resume");
  EXPECT_FALSE(robot.pause().done);
  EXPECT_FALSE(robot.start().done);
  EXPECT_TRUE(robot.resume().done);
  EXPECT_GT(at(robot, 10.0).command.speed, 0.0);
  EXPECT_EQ(robot.follower().target(), 1U);
  EXPECT_TRUE(robot.stop().done);
  expect_standing(robot, "stopped: by order, waiting for start");
  EXPECT_FALSE(robot.resume().done);
  EXPECT_FALSE(robot.skip().done);
  EXPECT_TRUE(robot.start().done);
  EXPECT_EQ(robot.follower().target(), 0U);
}

TEST(WaypointMission, GoesStraightAfterAPauseInWhichTheHeadingWasLost) {
  WaypointMission robot = mission();
  at(robot, 0.0);
  robot.pause();
  robot.command({}, 0.0, Trust::kNotReady);
  robot.resume();
  EXPECT_EQ(robot.command({0.0, 0.0, 2.0}, 0.0, Trust::kAligning).command.steering_angle, 0.0);
}

TEST(WaypointMission, SkipsWhileDrivingAndWhilePaused) {
  WaypointMission robot = mission(false);
  at(robot, 0.0);
  EXPECT_EQ(robot.skip().message, "next is waypoint 2 of 3");
  robot.pause();
  EXPECT_EQ(robot.skip().message, "next is waypoint 3 of 3");
  expect_standing(robot, "paused: waiting for resume");
  EXPECT_EQ(robot.skip().message, "the last waypoint is skipped: finished");
  EXPECT_FALSE(robot.skip().done);
}

TEST(WaypointMission, GoesStraightToTheNextAfterASkip) {
  WaypointFollowerParameters parameters;
  WaypointMission robot(parameters, {{10.0, 0.0}, {10.0, 10.0}}, true);
  robot.command({0.0, 0.0, 0.25 * kPi}, 0.0, Trust::kGood);
  robot.skip();
  const FollowerOutput output = robot.command({0.0, 0.0, 0.25 * kPi}, 0.0, Trust::kGood);
  EXPECT_NEAR(output.command.steering_angle, 0.0, 1e-9);
}

TEST(WaypointMission, EndsTheRoundUnderWayWhenLoopIsTakenAway) {
  WaypointMission robot = mission();
  drive_to_the_end(robot);
  at(robot, 10.0);
  ASSERT_EQ(robot.follower().target(), 1U);
  EXPECT_TRUE(robot.set_loop(false).done);
  EXPECT_GT(at(robot, 11.0).command.speed, 0.0);
  at(robot, 20.0);
  EXPECT_EQ(at(robot, 30.0).status, "finished");
}

TEST(WaypointMission, LoopDoesNotSetAFinishedRobotInMotion) {
  WaypointMission robot = mission(false);
  drive_to_the_end(robot);
  EXPECT_FALSE(robot.pause().done);
  robot.set_loop(true);
  expect_standing(robot, "finished");
  EXPECT_TRUE(robot.start().done);
  EXPECT_GT(at(robot, 0.0).command.speed, 0.0);
}

TEST(WaypointMission, StandsByOrderOrAtTheEnd) {
  WaypointMission robot = mission(false, false);
  EXPECT_TRUE(robot.stands());
  robot.start();
  robot.command({}, 0.0, Trust::kLost);
  EXPECT_FALSE(robot.stands()) << "it would drive on";
  robot.pause();
  EXPECT_TRUE(robot.stands());
  robot.resume();
  drive_to_the_end(robot);
  EXPECT_TRUE(robot.stands());
}

TEST(WaypointMission, RefusesToStartWithoutWaypoints) {
  WaypointMission robot({}, {}, false);
  EXPECT_EQ(robot.start().message, "no waypoints");
  EXPECT_FALSE(robot.skip().done);
}

TEST(WaypointMission, SaysWhyThereAreNoWaypointsUntilThereAre) {
  WaypointMission robot = mission();
  robot.stand_without_waypoints("waiting for map");
  expect_standing(robot, "stopped: waiting for map");
  EXPECT_EQ(robot.skip().message, "waiting for map");
  robot.set_waypoints(kLine);
  EXPECT_GT(at(robot, 0.0).command.speed, 0.0);
}

TEST(WaypointMission, StandsWhenFinishedThoughItsWaypointsWereGoneForAWhile) {
  WaypointMission robot = mission(false);
  drive_to_the_end(robot);
  robot.stand_without_waypoints("waiting for map");
  robot.set_waypoints(kLine);
  expect_standing(robot, "stopped: waiting for start");
}

TEST(WaypointMission, KeepsTheWaypointSteeredForWhenMapMoves) {
  WaypointMission robot = mission();
  at(robot, 0.0);
  at(robot, 10.0);
  robot.move_waypoints({{10.0, 5.0}, {20.0, 5.0}, {30.0, 5.0}});
  EXPECT_EQ(robot.follower().target(), 1U);
  robot.command({10.0, 5.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_EQ(robot.follower().target(), 1U);
  EXPECT_THROW(robot.move_waypoints({{10.0, 5.0}}), std::invalid_argument);
}

TEST(WaypointMission, KeepsItsWaypointsWhenNewOnesAreNotFinite) {
  WaypointMission robot = mission();
  EXPECT_THROW(robot.set_waypoints({{std::numeric_limits<double>::quiet_NaN(), 0.0}}), std::invalid_argument);
  EXPECT_EQ(robot.follower().waypoints().size(), kLine.size());
}

TEST(WaypointMission, IsHeldForAReasonUntilItIsResumed) {
  WaypointMission held = mission();
  at(held, 0.0);
  held.hold("emergency stop");
  const FollowerOutput output = at(held, 1.0);
  EXPECT_EQ(output.status, "paused: emergency stop, waiting for resume");
  EXPECT_TRUE(output.urgent);
  EXPECT_EQ(output.command.speed, 0.0);
  EXPECT_TRUE(held.resume().done);
  EXPECT_EQ(at(held, 1.0).status, "driving");
  held.pause();
  EXPECT_EQ(at(held, 1.0).status, "paused: waiting for resume");
  EXPECT_FALSE(at(held, 1.0).urgent);
}

TEST(WaypointMission, StandingByOrderIsNotHeld) {
  WaypointMission stopped = mission();
  stopped.stop();
  stopped.hold("emergency stop");
  expect_standing(stopped, "stopped: by order, waiting for start");
}

}  // namespace
}  // namespace multipath_localization
