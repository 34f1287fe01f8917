// A base that turns by the speeds of its wheels, in closed loop.

#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;  // [s]

WaypointFollowerParameters differential() {
  WaypointFollowerParameters p;
  p.limits.base = "differential";
  p.loop = false;
  p.steering_lag = 0.0;
  return p;
}

/// Where a drive from a pose ended, and the largest distance from its path after the first second at speed.
struct Drive {
  Pose2 end;
  double largest = 0.0;
  double widest = 0.0;  ///< distance from the start [m]
  double time = 0.0;
};

Drive drive(const std::vector<Eigen::Vector2d>& route, const WaypointFollowerParameters& p, Pose2 pose) {
  WaypointFollower follower(p, route);
  CommandLimiter limiter(p.limits, p.wheelbase);
  Drive drive;
  const Eigen::Vector2d start = pose.position();
  for (; drive.time < 600.0; drive.time += kStep) {
    const FollowerOutput wanted = follower.command(pose, 0.0, Trust::kGood);
    const double before = limiter.yaw_rate();
    const MotionCommand command = limiter.limited(wanted.command, wanted.urgent, kStep, wanted.spin);
    EXPECT_LE(std::abs(limiter.yaw_rate()), p.limits.max_yaw_rate + 1e-9);
    EXPECT_LE(std::abs(limiter.yaw_rate() - before), p.limits.max_yaw_acceleration * kStep + 1e-9);
    pose = pose * displacement({0.0, kStep, command.speed, limiter.yaw_rate()});
    if (follower.progress_on_path() != nullptr) {
      drive.largest = std::max(drive.largest, follower.progress_on_path()->deviation(pose.position()));
    }
    drive.widest = std::max(drive.widest, (pose.position() - start).norm());
    if (follower.finished() && command.speed == 0.0 && limiter.yaw_rate() == 0.0) break;
  }
  drive.end = pose;
  return drive;
}

TEST(DifferentialBase, TurnsOnTheSpotToGoBack) {
  const Drive back = drive({{-8.0, 0.0}}, differential(), {0.0, 0.0, 0.1});
  EXPECT_LT(back.largest, 0.05);
  EXPECT_NEAR(back.end.x, -8.0, 0.1);
  EXPECT_NEAR(back.end.y, 0.0, 0.05);
  EXPECT_LT(back.time, 20.0);
}

TEST(DifferentialBase, GoesToAGoalBesideIt) {
  const Drive beside = drive({{0.0, 0.5}}, differential(), {0.0, 0.0, 0.0});
  EXPECT_NEAR(beside.end.y, 0.5, 0.1);
  EXPECT_LT(beside.widest, 0.6);
}

TEST(DifferentialBase, KeepsItsPathThroughCorners) {
  WaypointFollowerParameters p = differential();
  p.switch_radius = 0.3;
  const Drive square = drive({{6.0, 0.0}, {6.0, 6.0}, {0.0, 6.0}, {0.0, 1.0}}, p, {0.0, 0.0, 0.0});
  EXPECT_LT(square.largest, 0.1);
  EXPECT_NEAR(square.end.y, 1.0, 0.1);
  EXPECT_NEAR(square.end.x, 0.0, 0.05);
}

TEST(DifferentialBase, TurnsBackWithinTheRadiusOfAWaypoint) {
  const Drive out_and_back = drive({{10.0, 0.0}, {0.0, 0.0}}, differential(), {0.0, 0.0, 0.0});
  EXPECT_LT(out_and_back.widest, 10.5);
  EXPECT_GT(out_and_back.widest, 8.9);
  EXPECT_NEAR(out_and_back.end.x, 0.0, 0.1);
}

}  // namespace
}  // namespace multipath_localization
