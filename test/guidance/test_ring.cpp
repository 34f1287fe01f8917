#include <gtest/gtest.h>

#include <cmath>

#include "guidance/ring.hpp"

namespace multipath_localization {
namespace {

const Ring kSquare({{0.0, 0.0}, {0.0, 4.0}, {4.0, 4.0}, {4.0, 0.0}});  // given clockwise

TEST(Ring, GoesRoundCounterClockwise) {
  EXPECT_EQ(kSquare.length(), 16.0);
  EXPECT_EQ(kSquare.area(), 16.0);
  const Eigen::Vector2d first = kSquare.at(0.0);
  EXPECT_LT((kSquare.at(16.0) - first).norm(), 1e-12);
  EXPECT_LT((kSquare.at(-1.0) - kSquare.at(15.0)).norm(), 1e-12);
  for (double s = 0.0; s < 16.0; s += 0.7) EXPECT_NEAR(kSquare.nearest(kSquare.at(s)), s, 1e-9);
}

TEST(Ring, LeadsByItsCornersEitherWay) {
  const double corner = kSquare.station(kSquare.nearest_corner({4.0, 0.0}));
  const std::vector<Eigen::Vector2d> on = kSquare.way(corner - 1.0, corner + 17.0);
  ASSERT_EQ(on.size(), 7U);  // round, and by the first corner again
  EXPECT_LT((on[1] - Eigen::Vector2d(4.0, 0.0)).norm(), 1e-12);
  const std::vector<Eigen::Vector2d> back = kSquare.way(corner + 1.0, corner - 1.0);
  ASSERT_EQ(back.size(), 3U);
  EXPECT_LT((back[0] - Eigen::Vector2d(4.0, 1.0)).norm(), 1e-12);
  EXPECT_LT((back[2] - Eigen::Vector2d(3.0, 0.0)).norm(), 1e-12);
}

TEST(Ring, KnowsItsLongestEdge) {
  EXPECT_NEAR(Ring({{0.0, 0.0}, {2.0, 0.0}, {2.0, 3.0}}).longest_edge(), std::atan2(-3.0, -2.0), 1e-12);
}

TEST(Ring, KnowsWhatItEncloses) {
  const Ring hook(
      {{0.0, 0.0}, {6.0, 0.0}, {6.0, 6.0}, {4.0, 6.0}, {4.0, 2.0}, {2.0, 2.0}, {2.0, 6.0}, {0.0, 6.0}});
  EXPECT_TRUE(hook.contains({1.0, 5.0}, 0.0));
  EXPECT_FALSE(hook.contains({3.0, 5.0}, 0.0));
  EXPECT_TRUE(hook.contains({2.05, 5.0}, 0.1));
  const auto sections = hook.sections(4.0);
  ASSERT_EQ(sections.size(), 2U);
  EXPECT_EQ(sections[0], std::make_pair(0.0, 2.0));
  EXPECT_EQ(sections[1], std::make_pair(4.0, 6.0));
  EXPECT_TRUE(hook.sections(7.0).empty());
}

}  // namespace
}  // namespace multipath_localization
