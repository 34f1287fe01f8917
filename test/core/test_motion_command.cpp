#include <gtest/gtest.h>

#include <limits>

#include "multipath_localization/core/motion_command.hpp"

namespace multipath_localization {
namespace {

TEST(MotionCommand, TurnsByWheelbaseAndSteeringAngle) {
  EXPECT_DOUBLE_EQ(yaw_rate({2.0, 0.0}, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(yaw_rate({2.0, std::atan(0.25)}, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(yaw_rate({-2.0, std::atan(0.25)}, 0.5), -1.0);
}

TEST(MotionCommand, ComesBackFromSpeedAndYawRate) {
  for (const double speed : {-1.5, 0.3, 10.0}) {
    for (const double turn : {-2.0, 0.0, 0.7}) {
      const MotionCommand command = motion_command(speed, turn, 0.8);
      EXPECT_EQ(command.speed, speed);
      EXPECT_NEAR(yaw_rate(command, 0.8), turn, 1e-12);
    }
  }
}

TEST(MotionCommand, AtRestTheWheelStaysStraight) {
  EXPECT_EQ(motion_command(0.0, 1.0, 0.5).steering_angle, 0.0);
}

TEST(MotionCommand, IsFiniteOnlyWithBothParts) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE((MotionCommand{1.0, 0.1}).finite());
  EXPECT_FALSE((MotionCommand{nan, 0.1}).finite());
  EXPECT_FALSE((MotionCommand{1.0, std::numeric_limits<double>::infinity()}).finite());
}

}  // namespace
}  // namespace multipath_localization
