#include <gtest/gtest.h>
#include <topic_tools/shape_shifter.h>

#include "ros/wheel_odometry_node/ackermann_message.hpp"

namespace multipath_localization {
namespace {

/// As rospy writes one with that stamp and frame, by the definition of ackermann_msgs.
const std::string kWritten(
    "\x07\x00\x00\x00\x64\x00\x00\x00\x00\x65\xcd\x1d\x04\x00\x00\x00"
    "base"
    "\x00\x00\x00\x3f\x00\x00\x00\x00\x00\x00\xc0\xbf\x00\x00\x00\x00\x00\x00\x00\x00",
    40);

TEST(AckermannMessage, IsReadAsItsPackageWritesIt) {
  std::string bytes = kWritten;
  ros::serialization::IStream in(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                 static_cast<std::uint32_t>(bytes.size()));
  AckermannDriveStamped message;
  ros::serialization::deserialize(in, message);
  EXPECT_EQ(message.header.seq, 7U);
  EXPECT_NEAR(message.header.stamp.toSec(), 100.5, 1e-9);
  EXPECT_EQ(message.header.frame_id, "base");
  EXPECT_EQ(message.steering_angle, 0.5F);
  EXPECT_EQ(message.speed, -1.5F);
  EXPECT_EQ(ros::serialization::serializationLength(message), bytes.size());
}

TEST(AckermannMessage, IsOfItsPackagesTypeToRos) {
  topic_tools::ShapeShifter message;
  message.morph("1fd5d7f58889cefd44d29f6653240d0c", "ackermann_msgs/AckermannDriveStamped", "", "");
  std::string bytes = kWritten;
  ros::serialization::IStream in(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                 static_cast<std::uint32_t>(bytes.size()));
  message.read(in);
  EXPECT_EQ(message.instantiate<AckermannDriveStamped>()->speed, -1.5F);
}

}  // namespace
}  // namespace multipath_localization
