// Legs to a place of rest that are shorter than what a base takes to come onto them, in closed loop.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/guidance/goal_driver.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;  // [s]

struct Drive {
  Pose2 end;
  double way = 0.0;     ///< driven [m]
  double widest = 0.0;  ///< distance from the start [m]
  std::string status;
  bool at_rest = false;
};

WaypointFollowerParameters parameters(const std::string& base) {
  WaypointFollowerParameters p;
  p.limits.base = base;
  p.loop = false;
  return p;
}

Drive drive(const std::vector<Eigen::Vector2d>& route, const WaypointFollowerParameters& p, Pose2 pose,
            const RouteTasks& tasks = {}) {
  WaypointFollower follower(p, route, tasks);
  CommandLimiter limiter(p.limits, p.wheelbase);
  Drive drive;
  const Eigen::Vector2d start = pose.position();
  for (double time = 0.0; time < 300.0 && !drive.at_rest; time += kStep) {
    const FollowerOutput wanted = follower.command(pose, 0.0, Trust::kGood, 0.0, time);
    const MotionCommand command = limiter.limited(wanted.command, wanted.urgent, kStep, wanted.spin);
    pose = pose * displacement({0.0, kStep, command.speed, limiter.yaw_rate()});
    drive.way += kStep * std::abs(command.speed);
    drive.widest = std::max(drive.widest, (pose.position() - start).norm());
    drive.status = wanted.status;
    drive.at_rest = follower.finished() && limiter.at_rest();
  }
  drive.end = pose;
  return drive;
}

double from(const Eigen::Vector2d& goal, const Drive& drive) { return (drive.end.position() - goal).norm(); }

class GoalDriverOf : public testing::TestWithParam<const char*> {};

/// All round the base, and from a turning circle's radius, 0.73 m, down to nearly nothing.
TEST_P(GoalDriverOf, ComesToAGoalBesideIt) {
  const WaypointFollowerParameters p = parameters(GetParam());
  for (const double distance : {0.15, 0.4, 0.7, 1.5, 3.0}) {
    for (double bearing = -3.0; bearing < 3.1; bearing += 0.5) {
      const Eigen::Vector2d goal = distance * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
      const Drive beside = drive({goal}, p, {});
      EXPECT_LT(from(goal, beside), 0.1) << distance << " m " << bearing << " rad";
      EXPECT_EQ(beside.status, "finished");
      EXPECT_TRUE(beside.at_rest);
    }
  }
}

TEST_P(GoalDriverOf, ComesToTheEndOfAShortLastLeg) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  for (int i = 0; i < 200; ++i) {
    WaypointFollowerParameters p = parameters(GetParam());
    p.cruise_speed = uniform(0.3, 3.0);
    p.switch_radius = uniform(0.3, 2.0);
    const Eigen::Vector2d corner(uniform(5.0, 20.0), uniform(-10.0, 10.0));
    const double bearing = uniform(-kPi, kPi);
    const Eigen::Vector2d goal =
        corner + uniform(0.2, 4.0) * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    const Drive there = drive({corner, goal}, p, {});
    EXPECT_LT(from(goal, there), 0.1) << i;
    EXPECT_TRUE(there.at_rest) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(GoalDriver, GoalDriverOf, testing::Values("front_steering", "differential"));

TEST(GoalDriver, KeepsToThePathWhereThatLeadsToTheGoal) {
  const WaypointFollowerParameters p = parameters("front_steering");
  EXPECT_NEAR(drive({{6.0, 0.0}}, p, {}).way, 6.0, 0.1);
  EXPECT_NEAR(drive({{6.0, 0.0}, {6.0, 6.0}}, p, {}).way, 12.0, 1.5);
}

TEST(GoalDriver, TurnsRoundNoWiderThanItMayDeviateAndSaysHowFarOffItEnds) {
  WaypointFollowerParameters p = parameters("front_steering");
  p.max_deviation = 1.0;
  const Drive narrow = drive({{0.0, 0.5}}, p, {});
  EXPECT_LT(narrow.widest, 1.6);
  EXPECT_TRUE(narrow.at_rest);
  EXPECT_EQ(narrow.status.rfind("finished 0.", 0), 0U) << narrow.status;
  p.max_deviation = 4.0;
  EXPECT_LT(from({0.0, 0.5}, drive({{0.0, 0.5}}, p, {})), 0.1);
}

TEST(GoalDriver, ComesToAShortLegsEndBackwards) {
  const WaypointFollowerParameters p = parameters("front_steering");
  WaypointTask backwards;
  backwards.reverse = true;
  const Eigen::Vector2d goal(4.5, 0.6);
  const Drive parked = drive({{5.0, 0.0}, goal}, p, {}, {{{}, backwards}});
  EXPECT_LT(from(goal, parked), 0.1);
}

}  // namespace
}  // namespace multipath_localization
