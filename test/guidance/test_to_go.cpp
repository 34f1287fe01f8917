#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "multipath_localization/guidance/to_go.hpp"

namespace multipath_localization {
namespace {

constexpr double kSpeed = 2.0;  // [m/s]

WaypointFollowerParameters parameters(bool loop) {
  WaypointFollowerParameters p;
  p.loop = loop;
  p.cruise_speed = kSpeed;
  return p;
}

TEST(ToGo, ShrinksAlongThePathToNothingAtItsEnd) {
  WaypointFollower follower(parameters(false), {{20.0, 0.0}, {40.0, 0.0}});
  follower.command({}, 0.0, Trust::kGood);
  const ToGo all = to_go(follower, kSpeed);
  EXPECT_NEAR(all.distance, 40.0, 0.01);
  EXPECT_GT(all.time, 40.0 / kSpeed);
  EXPECT_LT(all.time, 40.0 / kSpeed + 3.0);  // braking at the end
  follower.command({30.0, 0.0, 0.0}, 0.0, Trust::kGood);
  for (double x = 0.0; x <= 30.0; x += 0.5) follower.command({x, 0.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_NEAR(to_go(follower, kSpeed).distance, 10.0, 0.01);
  for (double x = 30.0; x <= 40.0; x += 0.5) follower.command({x, 0.0, 0.0}, 0.0, Trust::kGood);
  EXPECT_TRUE(follower.finished());
  EXPECT_EQ(to_go(follower, kSpeed).distance, 0.0);
}

TEST(ToGo, CountsWaitsAndWhatIsBehindThem) {
  RouteTasks tasks{{{}, {}}};
  tasks.at[0].wait = 7.0;
  tasks.at[1].speed = 0.5;
  WaypointFollower follower(parameters(false), {{20.0, 0.0}, {20.0, 10.0}}, tasks);
  follower.command({}, 0.0, Trust::kGood);
  const ToGo all = to_go(follower, kSpeed);
  EXPECT_NEAR(all.distance, 30.0, 0.01);
  EXPECT_NEAR(all.time, 20.0 / kSpeed + 7.0 + 10.0 / 0.5, 2.0);
  tasks.at[0].wait = std::numeric_limits<double>::infinity();
  const WaypointFollower by_call(parameters(false), {{20.0, 0.0}, {20.0, 10.0}}, tasks);
  EXPECT_TRUE(std::isinf(to_go(by_call, kSpeed).time));
}

TEST(ToGo, OfARouteDrivenRoundIsThatOfTheRound) {
  WaypointFollower follower(parameters(true), {{20.0, 0.0}, {20.0, 20.0}, {0.0, 20.0}, {0.0, 0.0}});
  follower.command({}, 0.0, Trust::kGood);
  EXPECT_NEAR(to_go(follower, kSpeed).distance, 80.0, 5.0);
  EXPECT_EQ(to_go(WaypointFollower(parameters(true), {}), kSpeed).time, 0.0);
}

}  // namespace
}  // namespace multipath_localization
