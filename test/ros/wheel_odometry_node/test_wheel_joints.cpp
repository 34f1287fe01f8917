#include <gtest/gtest.h>

#include <cmath>

#include "ros/wheel_odometry_node/wheel_joints.hpp"

namespace multipath_localization {
namespace {

const WheelJoints kJoints{{"front_left", "rear_left"}, {"right"}, {"steer"}};

sensor_msgs::JointState state(const std::vector<std::string>& names, const std::vector<double>& positions) {
  sensor_msgs::JointState message;
  message.name = names;
  message.position = positions;
  return message;
}

TEST(ReadJoints, FindsThemInAnyOrderAmongOthers) {
  const JointsRead read =
      read_joints(state({"arm", "steer", "right", "rear_left", "front_left"}, {9, 4, 3, 2, 1}), kJoints);
  EXPECT_TRUE(read.names_any);
  EXPECT_TRUE(read.missing.empty());
  EXPECT_EQ(read.readings.left[0].position, 1.0);
  EXPECT_EQ(read.readings.left[1].position, 2.0);
  EXPECT_EQ(read.readings.right[0].position, 3.0);
  EXPECT_EQ(read.readings.steering[0].position, 4.0);
  EXPECT_TRUE(std::isnan(read.readings.right[0].velocity));
}

TEST(ReadJoints, NamesThoseThatAreMissing) {
  const JointsRead read = read_joints(state({"right", "steer"}, {3, std::nan("")}), kJoints);
  EXPECT_TRUE(read.names_any);
  EXPECT_EQ(read.missing, (std::vector<std::string>{"front_left", "rear_left", "steer"}));
  EXPECT_FALSE(read.readings.left[1].told());
  EXPECT_TRUE(read.readings.right[0].told());
}

TEST(ReadJoints, OfAnArmNamesNone) {
  EXPECT_FALSE(read_joints(state({"shoulder", "elbow"}, {1, 2}), kJoints).names_any);
  EXPECT_FALSE(read_joints(sensor_msgs::JointState(), kJoints).names_any);
}

TEST(ReadJoints, TakesNothingFromListsOfAnotherLength) {
  sensor_msgs::JointState message = state({"right", "steer", "front_left", "rear_left"}, {1, 2});
  EXPECT_EQ(read_joints(message, kJoints).missing.size(), 4U);
  message.velocity = {5, 6, 7, 8};
  const JointsRead read = read_joints(message, kJoints);
  EXPECT_TRUE(read.missing.empty());
  EXPECT_EQ(read.readings.left[0].velocity, 7.0);
}

TEST(Words, ArePartedBySpaces) {
  EXPECT_EQ(words("  a_1  b "), (std::vector<std::string>{"a_1", "b"}));
  EXPECT_TRUE(words(" ").empty());
}

}  // namespace
}  // namespace multipath_localization
