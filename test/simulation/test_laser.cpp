#include <gtest/gtest.h>

#include <cmath>

#include "simulation/laser.hpp"

namespace multipath_localization {
namespace {

LaserParameters parameters() {
  LaserParameters p;
  p.rate = 10.0;
  p.noise = 0.0;
  return p;
}

/// A block of 2 m by 2 m whose west face is at x = `x`.
BuildingParameters block(double x) {
  BuildingParameters building;
  building.corners = {x, -1.0, x + 2.0, -1.0, x + 2.0, 1.0, x, 1.0};
  return building;
}

TEST(Laser, SeesTheNearestWallOfEachDirection) {
  Laser laser(parameters(), {block(5.0), block(9.0)}, 1);
  const std::vector<float> ahead = laser.scan({0.0, 0.0, 0.0});
  ASSERT_EQ(ahead.size(), 360U);
  EXPECT_NEAR(ahead[180], 5.0, 1e-6);
  EXPECT_NEAR(ahead[190], 5.0 / std::cos(10.0 * kPi / 180.0), 1e-5);
  EXPECT_TRUE(std::isinf(ahead[0]));
  EXPECT_TRUE(std::isinf(ahead[200]));
  EXPECT_NEAR(laser.scan({0.0, 0.0, 0.5 * kPi})[90], 5.0, 1e-6);  // to its right
}

TEST(Laser, SeesNothingBeyondItsRangeOrRightBeforeIt) {
  Laser laser(parameters(), {block(25.0)}, 1);
  EXPECT_TRUE(std::isinf(laser.scan({0.0, 0.0, 0.0})[180]));
  EXPECT_EQ(laser.scan({24.95, 0.0, 0.0})[180], 0.0F);
}

TEST(Laser, ScansAtItsRate) {
  Laser laser(parameters(), {}, 1);
  int scans = 0;
  for (int i = 1; i <= 100; ++i) scans += laser.due(0.01 * i) ? 1 : 0;
  EXPECT_EQ(scans, 10);
  Laser none(LaserParameters{}, {}, 1);
  EXPECT_FALSE(none.due(100.0));
}

TEST(Laser, OfTheSameSeedSeesTheSame) {
  LaserParameters p = parameters();
  p.noise = 0.1;
  Laser one(p, {block(5.0)}, 7);
  Laser other(p, {block(5.0)}, 7);
  EXPECT_EQ(one.scan({}), other.scan({}));
  EXPECT_NE(Laser(p, {block(5.0)}, 8).scan({}), other.scan({}));
}

}  // namespace
}  // namespace multipath_localization
