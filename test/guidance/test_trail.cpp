#include <gtest/gtest.h>

#include "multipath_localization/guidance/trail.hpp"

namespace multipath_localization {
namespace {

TEST(Trail, ComesByWhereTheRobotHasJustBeen) {
  Trail trail(3.0);
  EXPECT_TRUE(trail.empty());
  EXPECT_FALSE(trail.comes_by({0.0, 0.0}));
  for (double x = 0.0; x < 10.0; x += 0.05) trail.add({x, 0.0});
  EXPECT_NEAR(trail.latest().x(), 9.95, 0.1);
  EXPECT_TRUE(trail.comes_by({8.0, 0.2}));
  EXPECT_FALSE(trail.comes_by({8.0, 0.5}));
  EXPECT_FALSE(trail.comes_by({5.0, 0.0}));  // longer ago
  trail.clear();
  EXPECT_TRUE(trail.empty());
}

}  // namespace
}  // namespace multipath_localization
