#include <gtest/gtest.h>

#include <limits>

#include "guidance/polygon_inset.hpp"

namespace multipath_localization {
namespace {

TEST(PolygonInset, LiesSoFarWithin) {
  const std::vector<Ring> parts = inset(Ring({{0.0, 0.0}, {10.0, 0.0}, {10.0, 6.0}, {0.0, 6.0}}), 1.0);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts[0].area(), 32.0, 1e-9);
  EXPECT_EQ(parts[0].corners().size(), 4U);
}

TEST(PolygonInset, KeepsCornersThatPointInwards) {
  const Ring hook({{0.0, 0.0}, {10.0, 0.0}, {10.0, 4.0}, {4.0, 4.0}, {4.0, 10.0}, {0.0, 10.0}});
  const std::vector<Ring> parts = inset(hook, 1.0);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].corners().size(), 6U);
  EXPECT_NEAR(parts[0].area(), 8.0 * 2.0 + 6.0 * 2.0, 1e-9);
}

TEST(PolygonInset, FallsApartOrVanishes) {
  const Ring dumbbell({{0.0, 0.0},
                       {4.0, 0.0},
                       {4.0, 1.5},
                       {8.0, 1.5},
                       {8.0, 0.0},
                       {12.0, 0.0},
                       {12.0, 4.0},
                       {8.0, 4.0},
                       {8.0, 2.5},
                       {4.0, 2.5},
                       {4.0, 4.0},
                       {0.0, 4.0}});
  EXPECT_EQ(inset(dumbbell, 0.4).size(), 1U);
  EXPECT_EQ(inset(dumbbell, 1.0).size(), 2U);
  EXPECT_TRUE(inset(dumbbell, 2.5).empty());
}

TEST(PolygonInset, TellsWhatIsNoPolygon) {
  EXPECT_EQ(fault_of_polygon({{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}), "");
  EXPECT_EQ(fault_of_polygon({{0.0, 0.0}, {1.0, 0.0}}), "fewer than three corners");
  EXPECT_EQ(fault_of_polygon({{0.0, 0.0}, {4.0, 4.0}, {4.0, 0.0}, {0.0, 4.0}}), "edges that cross or touch");
  for (const std::vector<Eigen::Vector2d>& none : std::vector<std::vector<Eigen::Vector2d>>{
           {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}},
           {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}},
           {{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {4.0, 0.0}},
           {{0.0, 0.0}, {4.0, 0.0}, {std::numeric_limits<double>::quiet_NaN(), 1.0}}}) {
    EXPECT_NE(fault_of_polygon(none), "");
  }
}

}  // namespace
}  // namespace multipath_localization
