#include <gtest/gtest.h>

#include <algorithm>

#include "multipath_localization/core/parameters.hpp"
#include "simulation/polygon.hpp"

namespace multipath_localization {
namespace {

const std::vector<double> kL = {0, 0, 4, 0, 4, 2, 2, 2, 2, 4, 0, 4};  // a concave L

TEST(Polygon, ContainsWhatLiesWithinAConcaveOutline) {
  const Polygon l(kL, "l");
  EXPECT_TRUE(l.contains({1.0, 3.0}));
  EXPECT_TRUE(l.contains({3.0, 1.0}));
  EXPECT_FALSE(l.contains({3.0, 3.0}));
  EXPECT_FALSE(l.contains({-0.1, 2.0}));
}

TEST(Polygon, DepthIsTheSignedDistanceToTheNearestEdge) {
  const Polygon l(kL, "l");
  EXPECT_DOUBLE_EQ(l.depth({1.0, 1.5}), 1.0);
  EXPECT_DOUBLE_EQ(l.depth({3.0, 1.75}), 0.25);
  EXPECT_DOUBLE_EQ(l.depth({3.0, 3.0}), -1.0);
  EXPECT_DOUBLE_EQ(l.depth({7.0, -4.0}), -5.0);
}

TEST(Polygon, KnowsItsSenseOfRotation) {
  EXPECT_TRUE(Polygon(kL, "l").counter_clockwise());
  EXPECT_FALSE(Polygon({0, 0, 0, 1, 1, 0}, "triangle").counter_clockwise());
}

TEST(Polygon, DoesNotCareForTheSenseOfRotation) {
  std::vector<double> reversed = kL;
  std::reverse(reversed.begin(), reversed.end());
  for (std::size_t i = 0; i < reversed.size(); i += 2) std::swap(reversed[i], reversed[i + 1]);
  const Eigen::Vector2d point(1.2, 0.7);
  EXPECT_DOUBLE_EQ(Polygon(reversed, "l").depth(point), Polygon(kL, "l").depth(point));
}

TEST(Polygon, TrianglesCoverItsArea) {
  const Polygon l(kL, "l");
  const std::vector<Eigen::Vector2d> corners = l.triangles();
  ASSERT_EQ(corners.size(), 12U);
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Eigen::Vector2d u = corners[i + 1] - corners[i];
    const Eigen::Vector2d v = corners[i + 2] - corners[i];
    const double part = 0.5 * (u.x() * v.y() - u.y() * v.x());
    EXPECT_GE(part, 0.0);
    area += part;
    EXPECT_GE(l.depth((corners[i] + corners[i + 1] + corners[i + 2]) / 3.0), 0.0);
  }
  EXPECT_DOUBLE_EQ(area, 12.0);
}

TEST(Polygon, RefusesFewerThanThreeCorners) {
  EXPECT_THROW(Polygon({}, "empty"), ParameterError);
  EXPECT_THROW(Polygon({0, 0, 1, 0}, "line"), ParameterError);
  EXPECT_THROW(Polygon({0, 0, 1, 0, 1, 1, 2}, "odd"), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
