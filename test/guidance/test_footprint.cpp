#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "multipath_localization/guidance/footprint.hpp"

namespace multipath_localization {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();

/// 1 m ahead of its origin, 0.5 m behind, 0.8 m wide, and 0.1 m more to both sides when it drives.
Footprint robot() { return {1.0, 0.5, 0.8, 0.1}; }

/// East from the origin.
std::vector<Pose2> straight() {
  std::vector<Pose2> way;
  for (int i = 0; i <= 50; ++i) way.push_back({0.1 * i, 0.0, 0.0});
  return way;
}

TEST(Footprint, IsMeasuredFromTheOriginOfTheBase) {
  EXPECT_TRUE(robot().holds({0.99, 0.39}));
  EXPECT_FALSE(robot().holds({1.01, 0.0}));
  EXPECT_FALSE(robot().holds({-0.51, 0.0}));
  EXPECT_FALSE(robot().holds({0.0, 0.41}));
  EXPECT_TRUE(robot().holds({0.0, 0.41}, 0.1));
  EXPECT_NEAR(robot().radius(), std::hypot(1.0, 0.4), 1e-12);
}

TEST(FreeWay, EndsWhereTheFrontReachesAnObstacle) {
  EXPECT_NEAR(free_way(straight(), robot(), {{4.0, 0.0}}), 3.0, 0.11);
  EXPECT_NEAR(free_way(straight(), robot(), {{4.0, 0.45}, {5.0, 0.0}}), 3.0, 0.11);
  EXPECT_EQ(free_way(straight(), robot(), {{4.0, 0.55}, {7.0, 0.0}, {-2.0, 0.0}}), kForEver);
  EXPECT_EQ(free_way(straight(), robot(), {}), kForEver);
}

TEST(FreeWay, FollowsTheWayRoundABend) {
  std::vector<Pose2> bend;
  for (int i = 0; i <= 30; ++i) {
    const double turn = 0.05 * i;
    bend.push_back({3.0 * std::sin(turn), 3.0 * (1.0 - std::cos(turn)), turn});
  }
  EXPECT_EQ(free_way(bend, robot(), {{4.5, 0.0}}), kForEver);  // straight ahead, where it does not go
  EXPECT_LT(free_way(bend, robot(), {{3.0, 3.0}}), 3.9);
}

TEST(FreeWay, LetsTheBaseOutOfANarrowPlaceButNotIntoItsWall) {
  EXPECT_EQ(free_way(straight(), robot(), {{0.5, 0.45}}), kForEver);
  EXPECT_EQ(free_way(straight(), robot(), {{0.5, 0.39}}), 0.0);
}

TEST(FreeWay, LooksBehindABaseThatDrivesBack) {
  std::vector<Pose2> back;
  for (int i = 0; i <= 50; ++i) back.push_back({-0.1 * i, 0.0, 0.0});
  EXPECT_NEAR(free_way(back, robot(), {{-3.0, 0.0}, {1.5, 0.0}}), 2.5, 0.11);
}

TEST(FreeToTurn, WithinTheCircleOfTheOutline) {
  const Pose2 pose{10.0, 0.0, 1.0};
  EXPECT_TRUE(free_to_turn(pose, robot(), {{11.1, 0.0}, {10.0, -1.1}}));
  EXPECT_FALSE(free_to_turn(pose, robot(), {{10.0, -1.0}}));
}

}  // namespace
}  // namespace multipath_localization
