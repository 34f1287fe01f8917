// Ways that are driven backwards, in closed loop with bases that lag and poses that are late.

#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/guidance/coming_way.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"
#include "steered_base.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;  // [s]

struct Parked {
  Pose2 pose;
  double largest = 0.0;  ///< distance from the path [m]
  double slowest = 0.0;  ///< command, backwards [m/s]
  bool at_rest = false;
};

WaypointTask backwards() {
  WaypointTask task;
  task.reverse = true;
  return task;
}

Parked drive(const std::vector<Eigen::Vector2d>& route, const RouteTasks& tasks,
             const WaypointFollowerParameters& p, const BaseTraits& traits) {
  WaypointFollower follower(p, route, tasks);
  CommandLimiter limiter(p.limits, p.wheelbase);
  SteeredBase base(traits, {});
  Parked parked;
  for (double time = 0.0; time < 600.0 && !parked.at_rest; time += kStep) {
    const Pose2 now = limiter.carried_forward(base.arrived(), traits.pose_age);
    const FollowerOutput wanted = follower.command(now, traits.pose_age, Trust::kGood, 0.0, time);
    const MotionCommand command = limiter.limited(wanted.command, wanted.urgent, kStep);
    base.step(command, kStep);
    parked.slowest = std::min(parked.slowest, command.speed);
    if (follower.driver() != nullptr) {
      parked.largest =
          std::max(parked.largest, follower.driver()->progress().deviation(base.pose().position()));
    }
    parked.at_rest = follower.finished() && command.speed == 0.0;
  }
  parked.pose = base.pose();
  return parked;
}

/// Past a place in a row, and back into it round a corner as wide as the base turns.
TEST(Reverse, ParksBackwards) {
  for (const double wheelbase : {0.3, 0.5, 1.0, 3.0}) {
    for (const double speed : {0.3, 1.5}) {
      const BaseTraits traits{wheelbase, 0.2, 0.1};
      WaypointFollowerParameters p;
      p.loop = false;
      p.wheelbase = wheelbase;
      p.cruise_speed = speed;
      p.steering_lag = traits.steering_lag;
      const double radius = 1.0 / p.tightest_curvature();
      p.switch_radius = std::max(0.5, radius);
      const double size = 4.0 + 4.0 * radius;
      const std::vector<Eigen::Vector2d> route = {{3.0 * size, 0.0}, {1.5 * size, 0.0}, {1.5 * size, -size}};
      const Parked parked = drive(route, {{{}, backwards(), backwards()}}, p, traits);
      SCOPED_TRACE("wheelbase " + std::to_string(wheelbase) + ", speed " + std::to_string(speed));
      EXPECT_TRUE(parked.at_rest);
      EXPECT_NEAR(parked.slowest, -speed, 1e-9);
      EXPECT_LT((parked.pose.position() - route.back()).norm(), 0.1);
      EXPECT_LT(std::abs(angle_difference(parked.pose.yaw, 0.5 * kPi)), 0.1);
      EXPECT_LT(parked.largest, 0.15);
    }
  }
}

TEST(Reverse, IsWhereTheComingWayLeads) {
  WaypointFollowerParameters p;
  p.loop = false;
  WaypointFollower follower(p, {{-10.0, 0.0}}, {{backwards()}});
  const FollowerOutput wanted = follower.command({}, 0.0, Trust::kGood);
  EXPECT_LT(wanted.command.speed, 0.0);
  const std::vector<Pose2> way = coming_way(follower, p, {}, wanted.command, 3.0);
  EXPECT_NEAR(way.back().x, -3.0, 0.11);
  EXPECT_NEAR(way.back().yaw, 0.0, 1e-6);
}

}  // namespace
}  // namespace multipath_localization
