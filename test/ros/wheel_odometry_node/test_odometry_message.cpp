#include <gtest/gtest.h>

#include "ros/inputs/odometry_reader.hpp"
#include "ros/wheel_odometry_node/odometry_message.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.05;

TEST(OdometryMessage, IsReadBackAsTheMotionItIsOf) {
  OdometryReader reader({}, "map");
  Pose2 pose;
  for (int i = 1; i <= 100; ++i) {
    const OdometryIncrement motion{100.0 + kStep * i, kStep, -1.0, 0.3, 0.2};
    pose = pose * displacement(motion);
    const CheckedOdometry checked =
        reader.read(to_odometry(ros::Time(motion.stamp), motion, pose, WheelOdometryParameters()));
    EXPECT_EQ(checked.reason, Reason::kAccepted);
    EXPECT_NEAR(checked.increment.speed, motion.speed, 1e-6);
    EXPECT_NEAR(checked.increment.yaw_rate, motion.yaw_rate, 1e-6);
    EXPECT_NEAR(checked.increment.lateral_speed, motion.lateral_speed, 1e-6);
    EXPECT_NEAR(checked.base_in_odom.x, pose.x, 1e-9);
  }
}

TEST(OdometryMessage, DeclaresWhatItDoesNotKnow) {
  const nav_msgs::Odometry message =
      to_odometry(ros::Time(1.0), {1.0, kStep, 2.0, 0.0, 0.0}, Pose2(), WheelOdometryParameters());
  EXPECT_EQ(message.header.frame_id, "odom");
  EXPECT_EQ(message.child_frame_id, "base_link");
  EXPECT_NEAR(message.twist.covariance[0], 0.01, 1e-9) << "5 % of the speed";
  EXPECT_GT(message.twist.covariance[7], 0.0);
  EXPECT_GT(message.twist.covariance[35], 0.0);
  EXPECT_GE(message.pose.covariance[0], 1e6) << "dead reckoning is no position";
}

}  // namespace
}  // namespace multipath_localization
