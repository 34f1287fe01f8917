#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ros/inputs/antenna_frames.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {
namespace {

geometry_msgs::TransformStamped joint(const std::string& parent, const std::string& child, double x, double y,
                                      double yaw = 0.0) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform = to_transform({x, y, yaw});
  return transform;
}

testing::AssertionResult IsAt(const std::optional<Eigen::Vector2d>& place, double x, double y) {
  if (!place) return testing::AssertionFailure() << "not on the robot";
  if ((*place - Eigen::Vector2d(x, y)).norm() < 1e-9) return testing::AssertionSuccess();
  return testing::AssertionFailure() << place->transpose();
}

TEST(AntennaFrames, FixedJointsOnTfRideAsStaticOnesDo) {
  for (const bool is_static : {false, true}) {
    AntennaFrames frames({});
    frames.add(joint("/base_footprint", "/base_link", -0.5, 0.0), is_static);
    frames.add(joint("base_footprint", "gps", 0.4, 0.3), is_static);
    for (int i = 0; i < 10; ++i) {
      frames.add(joint("odom", "base_footprint", 1.0 * i, 0.0, 0.1 * i), false);
      EXPECT_TRUE(IsAt(frames.in_base("/gps"), 0.9, 0.3)) << "through base_footprint, whatever odom does";
    }
  }
}

TEST(AntennaFrames, TheBaseItselfNeedsNoTransform) {
  AntennaFrames frames({});
  EXPECT_TRUE(IsAt(frames.in_base(""), 0.0, 0.0));
  EXPECT_TRUE(IsAt(frames.in_base("/base_link"), 0.0, 0.0));
}

TEST(AntennaFrames, TellsHowHighAFrameIs) {
  AntennaFrames frames({});
  geometry_msgs::TransformStamped mast = joint("base_link", "gps", 0.4, 0.3);
  mast.transform.translation.z = 1.2;
  frames.add(mast, true);
  EXPECT_EQ(frames.height_in_base("/gps"), 1.2);
  EXPECT_EQ(frames.height_in_base("base_link"), 0.0);
  EXPECT_EQ(frames.height_in_base("elsewhere"), 0.0);
}

TEST(AntennaFrames, TurnsAndChainsAreFollowed) {
  AntennaFrames frames({});
  frames.add(joint("base_link", "mast", 1.0, 0.0, 0.5 * kPi), true);
  frames.add(joint("mast", "gps", 0.5, 0.0), false);
  EXPECT_TRUE(IsAt(frames.in_base("gps"), 1.0, 0.5));
}

TEST(AntennaFrames, AFrameThatIsNotJoinedMayCome) {
  AntennaFrames frames({});
  EXPECT_TRUE(frames.may_come("gps"));
  frames.add(joint("mast", "gps", 0.5, 0.0), true);
  EXPECT_FALSE(frames.in_base("gps"));
  EXPECT_TRUE(frames.may_come("/gps")) << "its mast is not placed yet";
  EXPECT_EQ(frames.described("gps"), "gps");
  frames.add(joint("base_link", "mast", 1.0, 0.0), false);
  EXPECT_TRUE(IsAt(frames.in_base("gps"), 1.5, 0.0));
  EXPECT_FALSE(frames.may_come("gps"));
}

TEST(AntennaFrames, WhatStaysOnTheGroundDoesNotRide) {
  AntennaFrames frames({"map", "odom", "base_link"});
  frames.add(joint("robot_odom", "base_footprint", 1.0, 0.0), false);
  frames.add(joint("base_footprint", "base_link", 0.0, 0.0), true);
  frames.add(joint("base_footprint", "low", 0.2, 0.0), true);
  frames.add(joint("robot_odom", "beacon", 1.5, 0.0), true);
  EXPECT_TRUE(IsAt(frames.in_base("low"), 0.2, 0.0));
  for (const char* ground : {"beacon", "robot_odom", "map", "/odom", "earth", "world", "site/utm"}) {
    EXPECT_FALSE(frames.in_base(ground)) << ground;
    EXPECT_FALSE(frames.may_come(ground) && std::string(ground) != "beacon") << ground;
    EXPECT_NE(frames.described(ground).find("does not ride on the robot"), std::string::npos) << ground;
  }
}

TEST(AntennaFrames, WhatMovesOnTheBaseIsNoMast) {
  AntennaFrames frames({});
  frames.add(joint("base_link", "turret", 0.0, 0.0, 0.0), false);
  frames.add(joint("turret", "gps", 0.6, 0.0), true);
  frames.add(joint("turret", "axis", 0.0, 0.0), true);
  EXPECT_TRUE(IsAt(frames.in_base("gps"), 0.6, 0.0));
  frames.add(joint("base_link", "turret", 0.0, 0.0, 0.1), false);
  EXPECT_TRUE(IsAt(frames.in_base("gps"), 0.6, 0.0)) << "as a chassis sways";
  EXPECT_TRUE(IsAt(frames.in_base("axis"), 0.0, 0.0));
  frames.add(joint("base_link", "turret", 0.0, 0.0, 1.0), false);
  EXPECT_FALSE(frames.in_base("gps"));
  EXPECT_FALSE(frames.may_come("gps"));
  EXPECT_NE(frames.described("gps").find("moves"), std::string::npos);
  frames.add(joint("base_link", "turret", 0.0, 0.0, 0.0), false);
  EXPECT_FALSE(frames.in_base("gps")) << "once seen to move";
  EXPECT_TRUE(IsAt(frames.in_base("axis"), 0.0, 0.0)) << "which does not move the antenna";
}

TEST(AntennaFrames, AStaticTransformToldAnewCorrects) {
  AntennaFrames frames({});
  frames.add(joint("base_link", "gps", 0.0, 0.0), true);
  EXPECT_TRUE(IsAt(frames.in_base("gps"), 0.0, 0.0));
  frames.add(joint("base_link", "gps", 0.9, 0.0), true);
  EXPECT_TRUE(IsAt(frames.in_base("gps"), 0.9, 0.0));
}

TEST(AntennaFrames, AnAntennaFarFromTheBaseIsOnNoRobot) {
  AntennaFrames frames({});
  frames.add(joint("base_link", "gps", 30.0, 0.0), true);
  EXPECT_FALSE(frames.in_base("gps"));
  EXPECT_NE(frames.described("gps").find("20 m"), std::string::npos);
}

TEST(AntennaFrames, RefuseWhatIsNoTransform) {
  AntennaFrames frames({});
  auto spoilt = joint("base_link", "gps", 0.9, 0.0);
  spoilt.transform.rotation.w = 7.0;
  EXPECT_FALSE(frames.add(spoilt, true));
  spoilt = joint("base_link", "gps", std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_FALSE(frames.add(spoilt, true));
  EXPECT_FALSE(frames.add(joint("gps", "gps", 0.9, 0.0), true));
  EXPECT_FALSE(frames.add(joint("", "gps", 0.9, 0.0), true));
  EXPECT_FALSE(frames.add(joint(std::string(300, 'x'), "gps", 0.9, 0.0), true));
  EXPECT_FALSE(frames.in_base("gps"));
  frames.add(joint("a", "b", 0.1, 0.0), true);
  frames.add(joint("b", "a", 0.1, 0.0), true);
  EXPECT_FALSE(frames.in_base("a")) << "a circle leads nowhere";
}

}  // namespace
}  // namespace multipath_localization
