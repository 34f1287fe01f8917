#include <gtest/gtest.h>

#include <cmath>

#include "guidance/goal_detours.hpp"

namespace multipath_localization {
namespace {

TEST(GoalDetours, LeadFromThePoseToTheGoalWithoutATurnTighterThanTold) {
  const Pose2 pose{1.0, -2.0, 0.7};
  for (const double bearing : {0.0, 0.8, 1.6, 2.4, 3.2, 4.0, 4.8, 5.6}) {
    for (const double distance : {0.1, 0.5, 2.0, 10.0}) {
      const Eigen::Vector2d goal =
          pose.position() + distance * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
      const std::vector<Path> ways = goal_detours(pose, goal, 0.8, {0.0, 0.8, 1.6});
      ASSERT_FALSE(ways.empty());
      for (const Path& way : ways) {
        EXPECT_LT((way.at(0.0).position - pose.position()).norm(), 1e-9);
        EXPECT_NEAR(way.at(0.0).heading, pose.yaw, 1e-9);
        EXPECT_LT((way.at(way.length()).position - goal).norm(), 1e-6);
        for (const PathPiece& piece : way.pieces()) EXPECT_LE(std::abs(piece.curvature), 1.0 / 0.8 + 1e-9);
      }
    }
  }
}

TEST(GoalDetours, BeginWithTheShortest) {
  const std::vector<Path> ways = goal_detours({}, {3.0, 2.0}, 0.8, {0.0, 1.0});
  ASSERT_EQ(ways.size(), 4U);
  for (std::size_t i = 1; i < ways.size(); ++i) EXPECT_GE(ways[i].length(), ways[i - 1].length());
  EXPECT_LT(ways.front().length(), 4.0);
}

TEST(GoalDetours, GoOnUntilTheGoalLiesOutsideTheCircle) {
  EXPECT_EQ(goal_detours({}, {0.0, 0.5}, 1.0, {0.0}).size(), 1U);  // to the other side alone
  EXPECT_EQ(goal_detours({}, {0.0, 0.5}, 1.0, {1.0}).size(), 2U);
}

}  // namespace
}  // namespace multipath_localization
