#include <gtest/gtest.h>

#include "multipath_localization/core/twist_sample.hpp"

namespace multipath_localization {
namespace {

TEST(TwistSample, MotionBetweenTwoIsTheirMean) {
  const OdometryIncrement u = motion_between({10.0, 1.0, 0.2, -0.4}, {10.5, 2.0, 0.4, 0.0});
  EXPECT_DOUBLE_EQ(u.stamp, 10.5);
  EXPECT_DOUBLE_EQ(u.duration, 0.5);
  EXPECT_DOUBLE_EQ(u.speed, 1.5);
  EXPECT_DOUBLE_EQ(u.yaw_rate, 0.3);
  EXPECT_DOUBLE_EQ(u.lateral_speed, -0.2);
}

TEST(TwistSample, MotionOfOneIsItsOwn) {
  const OdometryIncrement u = motion_of({10.0, 1.0, 0.2, -0.4}, kFirstInterval);
  EXPECT_DOUBLE_EQ(u.stamp, 10.0);
  EXPECT_DOUBLE_EQ(u.duration, kFirstInterval);
  EXPECT_DOUBLE_EQ(u.speed, 1.0);
  EXPECT_DOUBLE_EQ(u.yaw_rate, 0.2);
  EXPECT_DOUBLE_EQ(u.lateral_speed, -0.4);
}

}  // namespace
}  // namespace multipath_localization
