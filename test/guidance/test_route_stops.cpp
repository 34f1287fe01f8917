// What is done along a route beside driving: waits, speeds told, headings at the goal.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "multipath_localization/guidance/waypoint_mission.hpp"
#include "steered_base.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;  // [s]

/// A robot without lag, driven along a mission.
class Drive {
 public:
  explicit Drive(const WaypointFollowerParameters& p, WaypointMission& mission)
      : mission_(mission), limiter_(p.limits, p.wheelbase) {}

  /// Drives until the status begins so and the robot is at rest, for two minutes at most.
  void until(const std::string& status) {
    for (double end = time_ + 120.0; time_ < end; time_ += kStep) {
      step();
      if (status_.rfind(status, 0) == 0 && limiter_.at_rest()) return;
    }
    ADD_FAILURE() << "still " << status_ << " at " << pose_.x << ", " << pose_.y;
  }

  void step() {
    const FollowerOutput wanted = mission_.command(pose_, 0.0, Trust::kGood, 0.0, time_);
    const MotionCommand command = limiter_.limited(wanted.command, wanted.urgent, kStep, wanted.spin);
    pose_ = pose_ * displacement({0.0, kStep, command.speed, limiter_.yaw_rate()});
    status_ = wanted.status;
    fastest_ = std::max(fastest_, command.speed);
  }

  [[nodiscard]] const Pose2& pose() const { return pose_; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] double fastest() const { return fastest_; }

 private:
  WaypointMission& mission_;
  CommandLimiter limiter_;
  Pose2 pose_;
  double time_ = 0.0;
  double fastest_ = 0.0;
  std::string status_;
};

WaypointFollowerParameters once() {
  WaypointFollowerParameters p;
  p.loop = false;
  return p;
}

WaypointTask waiting(double seconds) {
  WaypointTask task;
  task.wait = seconds;
  return task;
}

TEST(RouteStops, WaitsAtAWaypointAndGoesOn) {
  const WaypointFollowerParameters p = once();
  WaypointMission mission(p, {}, true);
  mission.set_waypoints({{10.0, 0.0}, {20.0, 0.0}}, {{waiting(5.0), {}}});
  Drive drive(p, mission);
  drive.until("waiting for 5 s");
  EXPECT_NEAR(drive.pose().x, 10.0, 0.1);
  EXPECT_FALSE(mission.stands());  // nobody else is to drive it
  const double since = drive.time();
  drive.until("finished");
  EXPECT_NEAR(drive.pose().x, 20.0, 0.1);
  EXPECT_GT(drive.time() - since, 5.0 + 10.0 / p.cruise_speed);
}

TEST(RouteStops, WaitsUntilItIsResumed) {
  const WaypointFollowerParameters p = once();
  WaypointMission mission(p, {}, true);
  mission.set_waypoints({{10.0, 0.0}, {20.0, 0.0}}, {{waiting(std::numeric_limits<double>::infinity()), {}}});
  Drive drive(p, mission);
  EXPECT_FALSE(mission.resume().done);
  drive.until("waiting for resume");
  for (int i = 0; i < 5000; ++i) drive.step();
  EXPECT_NEAR(drive.pose().x, 10.0, 0.1);
  EXPECT_EQ(mission.resume().message, "driving on");
  drive.until("finished");
}

TEST(RouteStops, ASkipEndsAWaitAndNoMore) {
  const WaypointFollowerParameters p = once();
  WaypointMission mission(p, {}, true);
  mission.set_waypoints({{10.0, 0.0}, {20.0, 0.0}}, {{waiting(1000.0), {}}});
  Drive drive(p, mission);
  drive.until("waiting");
  EXPECT_EQ(mission.skip().message, "next is waypoint 2 of 2");
  drive.until("finished");
  EXPECT_NEAR(drive.pose().x, 20.0, 0.1);
}

TEST(RouteStops, KeepsTheSpeedToldOnTheWayToAWaypointAndNeverExceedsItsOwn) {
  const WaypointFollowerParameters p = once();
  WaypointMission mission(p, {}, true);
  RouteTasks tasks{{{}, {}, {}}};
  tasks.at[0].speed = 50.0;
  tasks.at[1].speed = 0.5;
  mission.set_waypoints({{10.0, 0.0}, {20.0, 0.0}, {30.0, 0.0}}, tasks);
  Drive drive(p, mission);
  while (drive.pose().x < 10.1) drive.step();
  EXPECT_EQ(drive.fastest(), p.cruise_speed);
  while (drive.pose().x < 19.9) {
    const double before = drive.pose().x;
    drive.step();
    EXPECT_LE((drive.pose().x - before) / kStep, 0.55);
  }
  const double before = drive.time();
  drive.until("finished");
  EXPECT_LT(drive.time() - before, 10.0 / p.cruise_speed + 3.0);
}

TEST(RouteStops, ADifferentialBaseTurnsToTheHeadingAtTheGoal) {
  WaypointFollowerParameters p = once();
  p.limits.base = "differential";
  for (const double heading : {0.0, 1.5, -3.0}) {
    WaypointMission mission(p, {}, true);
    RouteTasks tasks;
    tasks.final_heading = heading;
    mission.set_waypoints({{5.0, 0.0}}, tasks);
    Drive drive(p, mission);
    drive.until("finished");
    EXPECT_NEAR(drive.pose().x, 5.0, 0.1);
    EXPECT_LT(std::abs(angle_difference(drive.pose().yaw, heading)), 0.06) << heading;
  }
}

TEST(RouteStops, AGoalIsDrivenToOnceThoughRoutesAreDrivenRound) {
  WaypointFollowerParameters p = once();
  p.loop = true;
  WaypointMission mission(p, {}, true);
  RouteTasks tasks;
  tasks.once = true;
  mission.set_waypoints({{10.0, 0.0}, {10.0, 10.0}}, tasks);
  Drive drive(p, mission);
  drive.until("finished");
  EXPECT_NEAR(drive.pose().y, 10.0, 0.1);
}

TEST(RouteStops, AreKeptWhenTheRouteIsStartedAnew) {
  const WaypointFollowerParameters p = once();
  WaypointMission mission(p, {}, true);
  mission.set_waypoints({{10.0, 0.0}, {20.0, 0.0}}, {{waiting(5.0), {}}});
  mission.stop();
  mission.start();
  Drive drive(p, mission);
  drive.until("waiting for 5 s");
}

}  // namespace
}  // namespace multipath_localization
