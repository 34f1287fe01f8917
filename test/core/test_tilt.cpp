#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/tilt.hpp"

namespace multipath_localization {
namespace {

constexpr double kSlope = 0.2617993877991494;  ///< 15 degrees

TEST(Tilt, NoseUpLeansAMastBackwards) {
  const Eigen::Vector2d antenna = levelled(Tilt{0.0, -kSlope}, {0.0, 0.0, 1.0});
  EXPECT_NEAR(antenna.x(), -0.2588, 1e-4);
  EXPECT_NEAR(antenna.y(), 0.0, 1e-12);
}

TEST(Tilt, RightSideDownLeansAMastToTheRight) {
  const Eigen::Vector2d antenna = levelled(Tilt{kSlope, 0.0}, {0.4, 0.0, 1.0});
  EXPECT_NEAR(antenna.x(), 0.4, 1e-12);
  EXPECT_NEAR(antenna.y(), -0.2588, 1e-4);
}

TEST(Tilt, IsReadBackFromWhichWayIsUp) {
  const Tilt tilt = tilt_of(9.81 * up_in_base({0.3, -0.5}));
  EXPECT_NEAR(tilt.roll, 0.3, 1e-12);
  EXPECT_NEAR(tilt.pitch, -0.5, 1e-12);
}

TEST(Tilt, LevelGroundChangesNothingToTheBit) {
  const OdometryIncrement u{1.0, 0.02, 1.7, -0.3, 0.4};
  for (const OdometryIncrement& same : {over_map(Tilt{}, u), along_ground(Tilt{}, u)}) {
    EXPECT_EQ(same.speed, u.speed);
    EXPECT_EQ(same.lateral_speed, u.lateral_speed);
    EXPECT_EQ(same.yaw_rate, u.yaw_rate);
  }
  EXPECT_EQ(levelled(Tilt{}, Eigen::Vector3d(0.3, -0.2, 1.5)), Eigen::Vector2d(0.3, -0.2));
}

TEST(Tilt, TheWayUpASlopeIsLongerThanThatOnTheMap) {
  const OdometryIncrement u = over_map(Tilt{0.0, -kSlope}, OdometryIncrement{1.0, 0.02, 2.0, 0.0});
  EXPECT_NEAR(u.speed, 2.0 * std::cos(kSlope), 1e-12);
  EXPECT_NEAR(u.lateral_speed, 0.0, 1e-12);
}

TEST(Tilt, AGyroAndWheelsTellTheSameTurnOnASlope) {
  const Tilt tilt{0.2, -0.3};
  const double about_normal = 0.5;
  const double by_wheels = over_map(tilt, OdometryIncrement{1.0, 0.02, 0.0, about_normal}).yaw_rate;
  const double about_vertical = about_normal * up_in_base(tilt).z();
  EXPECT_NEAR(over_map(tilt, YawRate{1.0, about_vertical}).rate, by_wheels, 1e-12);
}

TEST(Tilt, WhatIsLevelledComesFromWhatWasMeasuredAlongTheGround) {
  const OdometryIncrement u{1.0, 0.02, 1.7, -0.3, 0.4};
  const Tilt tilt{0.2, -0.3};
  const OdometryIncrement back = over_map(tilt, along_ground(tilt, u));
  EXPECT_NEAR(back.speed, u.speed, 1e-12);
  EXPECT_NEAR(back.lateral_speed, u.lateral_speed, 1e-12);
  EXPECT_NEAR(back.yaw_rate, u.yaw_rate, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
