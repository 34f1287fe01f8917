#include <gtest/gtest.h>

#include <cmath>

#include "guidance/rounded_way.hpp"
#include "multipath_localization/guidance/path.hpp"
#include "path_of_way.hpp"

namespace multipath_localization {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

const Rounding kAnywhere{1.0, [](const Eigen::Vector2d& /*place*/) { return true; }};
const Rounding kNowhere{1.0, [](const Eigen::Vector2d& /*place*/) { return false; }};
/// Where the arc of a corner to the right, at the origin from the south, would cut it.
const Rounding kNotRightBelow{
    1.0, [](const Eigen::Vector2d& place) { return place.x() < 0.1 || place.y() > -0.1; }};

/// No turn but along arcs, and these of the radius.
void expect_smooth(const Path& path) {
  const std::vector<PathPiece>& pieces = path.pieces();
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    EXPECT_NEAR(pieces[i].heading, pieces[i - 1].at(pieces[i - 1].length).heading, 1e-6);
    EXPECT_LT((pieces[i].start - pieces[i - 1].at(pieces[i - 1].length).position).norm(), 1e-6);
    EXPECT_LE(std::abs(pieces[i].curvature), 1.0 + 1e-9);
  }
}

TEST(RoundedWay, TouchesItsLinesByArcs) {
  const auto way = rounded_way({{-5.0, 0.0}, {0.0, 0.0}, {0.0, 5.0}}, kAnywhere);
  ASSERT_TRUE(way);
  const Path path = path_of(*way);
  expect_smooth(path);
  EXPECT_NEAR(path.length(), 8.0 + 0.5 * kPi, 1e-9);
}

TEST(RoundedWay, LoopsWhereTheArcMayNotCome) {
  const auto loop = rounded_way({{0.0, -5.0}, {0.0, 0.0}, {5.0, 0.0}}, kNotRightBelow);
  ASSERT_TRUE(loop);
  const Path path = path_of(*loop);
  expect_smooth(path);
  EXPECT_NEAR(path.length(), 10.0 + 2.0 + 1.5 * kPi, 1e-9);  // straight over, and three quarters round
  EXPECT_FALSE(rounded_way({{0.0, -5.0}, {0.0, 0.0}, {5.0, 0.0}}, kNowhere));
}

TEST(RoundedWay, NeedsLinesAsLongAsItsArcsTake) {
  EXPECT_TRUE(rounded_way({{-5.0, 0.0}, {0.0, 0.0}, {0.0, 2.1}, {-5.0, 2.1}}, kAnywhere));
  EXPECT_FALSE(rounded_way({{-5.0, 0.0}, {0.0, 0.0}, {0.0, 1.9}, {-5.0, 1.9}}, kAnywhere));
  EXPECT_FALSE(rounded_way({{-5.0, 0.0}, {0.0, 0.0}, {0.0, 0.9}}, kAnywhere));
}

}  // namespace
}  // namespace multipath_localization
