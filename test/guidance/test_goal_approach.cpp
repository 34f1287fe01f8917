#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "multipath_localization/guidance/goal_approach.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"
#include "steered_base.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;  // [s]

WaypointFollowerParameters front_steering() {
  WaypointFollowerParameters p;
  p.loop = false;
  return p;
}

/// Where a base ends that drives to a goal from the origin, heading east.
Pose2 driven_to(const Goal& goal) {
  const WaypointFollowerParameters p = front_steering();
  SteeredBase base({p.wheelbase}, {});
  WaypointFollower follower(p, approach(goal, base.pose(), p));
  CommandLimiter limiter(p.limits, p.wheelbase);
  for (double time = 0.0; time < 300.0; time += kStep) {
    const FollowerOutput wanted = follower.command(base.pose(), 0.0, Trust::kGood);
    base.step(limiter.limited(wanted.command, wanted.urgent, kStep), kStep);
    if (follower.finished() && limiter.at_rest()) break;
  }
  return base.pose();
}

TEST(GoalApproach, BringsASteeredBaseToAGoalWithItsHeading) {
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  for (int i = 0; i < 100; ++i) {
    const Goal goal{{uniform(-20.0, 20.0), uniform(-20.0, 20.0)}, uniform(-kPi, kPi)};
    const Pose2 end = driven_to(goal);
    EXPECT_LT((end.position() - goal.position).norm(), 0.1) << i;
    EXPECT_LT(std::abs(angle_difference(end.yaw, *goal.heading)), 0.1) << i;
  }
}

TEST(GoalApproach, IsStraightWhereAnyHeadingWillDoOrTheBaseTurnsOnTheSpot) {
  WaypointFollowerParameters p = front_steering();
  EXPECT_EQ(approach({{5.0, 5.0}, std::nullopt}, Pose2{}, p).size(), 1U);
  EXPECT_EQ(approach({{5.0, 5.0}, 1.0}, Pose2{}, p).size(), 2U);
  EXPECT_EQ(approach({{5.0, 5.0}, 1.0}, std::nullopt, p).size(), 2U);
  p.limits.base = "differential";
  EXPECT_EQ(approach({{5.0, 5.0}, 1.0}, Pose2{}, p).size(), 1U);
}

TEST(GoalApproach, GoesOnAlongTheLineThatTheBaseIsOn) {
  const Goal ahead{{2.0, 0.1}, 0.0};
  EXPECT_EQ(approach(ahead, Pose2{0.0, 0.0, 0.1}, front_steering()).size(), 1U);
  EXPECT_EQ(approach(ahead, Pose2{0.0, 0.0, 0.5}, front_steering()).size(), 2U);
  EXPECT_EQ(approach(ahead, Pose2{3.0, 0.1, 0.0}, front_steering()).size(), 2U);
}

}  // namespace
}  // namespace multipath_localization
