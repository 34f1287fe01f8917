#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ros/steering_node/pose_input.hpp"

namespace multipath_localization {
namespace {

nav_msgs::Odometry pose_at(double x, double stamp) {
  nav_msgs::Odometry message;
  message.header.stamp = ros::Time(stamp);
  message.pose.pose.position.x = x;
  message.pose.pose.orientation.w = 1.0;
  message.pose.covariance[0] = 3.0;
  message.pose.covariance[7] = 5.0;
  return message;
}

LocalizationState state(int number) {
  LocalizationState message;
  message.state = static_cast<std::uint8_t>(number);
  return message;
}

TEST(PoseInput, HoldsThePoseAndItsUncertaintyToASide) {
  PoseInput input;
  input.take(pose_at(4.0, 100.0), ros::SteadyTime(10.0));
  EXPECT_EQ(input.pose().x, 4.0);
  EXPECT_DOUBLE_EQ(input.sigma(), 2.0);
  input.take(pose_at(std::numeric_limits<double>::infinity(), 100.0), ros::SteadyTime(10.0));
  EXPECT_FALSE(input.pose().finite());
}

TEST(PoseInput, AgesByItsStampAndWhereThatIsLongerSinceItArrived) {
  PoseInput input;
  EXPECT_TRUE(std::isnan(input.age({ros::Time(100.0), ros::SteadyTime(10.0)})));
  input.take(pose_at(0.0, 100.0), ros::SteadyTime(10.0));
  EXPECT_NEAR(input.age({ros::Time(100.3), ros::SteadyTime(10.1)}), 0.3, 1e-6);
  EXPECT_NEAR(input.age({ros::Time(99.0), ros::SteadyTime(10.1)}), -1.0, 1e-6);
  EXPECT_NEAR(input.age({ros::Time(100.0), ros::SteadyTime(12.0)}), 2.0, 1e-6);
}

TEST(PoseInput, TellsWhenThePoseBecomesUnknown) {
  PoseInput input;
  EXPECT_FALSE(input.known());
  EXPECT_FALSE(input.take(state(LocalizationState::GOOD)));
  EXPECT_TRUE(input.known());
  EXPECT_TRUE(input.take(state(LocalizationState::LOST)));
  EXPECT_FALSE(input.take(state(LocalizationState::LOST)));
  EXPECT_TRUE(input.take(state(LocalizationState::NOT_READY)));
  EXPECT_TRUE(input.take(state(77)));
  EXPECT_EQ(input.trust(), Trust::kLost);
}

}  // namespace
}  // namespace multipath_localization
