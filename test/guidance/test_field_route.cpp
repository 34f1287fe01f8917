// A field worked on in closed loop, by bases that lag and poses that are late.

#include <gtest/gtest.h>

#include "fields.hpp"
#include "multipath_localization/guidance/field_route.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"
#include "steered_base.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;  // [s]

/// The largest distance from the path once it has come onto it, and from the end [m].
struct Drive {
  double largest = 0.0;
  double from_end = 0.0;
};

Drive drive(const FieldRoute& route, const WaypointFollowerParameters& p) {
  WaypointFollower follower(p, route.waypoints, route.tasks);
  CommandLimiter limiter(p.limits, p.wheelbase);
  const BaseTraits traits{p.wheelbase, 0.2, 0.1};
  const Eigen::Vector2d way = route.waypoints[1] - route.waypoints[0];
  const double heading = std::atan2(way.y(), way.x());
  const Eigen::Vector2d before = route.waypoints[0] - 2.0 * way.normalized();
  SteeredBase base(traits, {before.x(), before.y(), heading});
  Drive drive;
  bool at_rest = false;
  for (double time = 0.0; time < 3600.0 && !at_rest; time += kStep) {
    const Pose2 now = limiter.carried_forward(base.arrived(), traits.pose_age);
    const FollowerOutput wanted = follower.command(now, traits.pose_age, Trust::kGood, 0.0, time);
    const MotionCommand command = limiter.limited(wanted.command, wanted.urgent, kStep, wanted.spin);
    base.step(command, kStep);
    if (follower.progress_on_path() != nullptr) {
      drive.largest = std::max(drive.largest, follower.progress_on_path()->deviation(base.pose().position()));
    }
    at_rest = follower.finished() && command.speed == 0.0;
  }
  EXPECT_TRUE(at_rest);
  drive.from_end = (base.pose().position() - route.waypoints.back()).norm();
  return drive;
}

TEST(FieldRoute, IsKeptWithinTheBoundsOfOtherRoutes) {
  for (const NamedField& field : fields()) {
    WaypointFollowerParameters p;
    p.steering_lag = 0.2;
    const FieldRoute route = field_route(field.border, {1.0}, {0.0, 0.0}, p);
    const Drive driven = drive(route, p);
    EXPECT_LT(driven.largest, 0.15) << field.name;
    EXPECT_LT(driven.from_end, 0.1) << field.name;
  }
}

TEST(FieldRoute, IsDrivenOnceAtTheSpeedTold) {
  FieldTask task{2.0};
  task.speed = 0.7;
  const FieldRoute route = field_route(fields()[0].border, task, {0.0, 0.0}, {});
  EXPECT_TRUE(route.tasks.once);
  ASSERT_EQ(route.tasks.at.size(), route.waypoints.size());
  for (const WaypointTask& at : route.tasks.at) EXPECT_EQ(at.speed, 0.7);
}

TEST(FieldRoute, OfADifferentialBaseTurnsInLessRoom) {
  WaypointFollowerParameters p;
  p.limits.base = "differential";
  const std::vector<Eigen::Vector2d> strip = {{0.0, 0.0}, {20.0, 0.0}, {20.0, 3.0}, {0.0, 3.0}};
  EXPECT_FALSE(field_route(strip, {0.6}, {0.0, 0.0}, p).waypoints.empty());
}

}  // namespace
}  // namespace multipath_localization
