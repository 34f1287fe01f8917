#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "ros/messages/conversions.hpp"
#include "ros/messages/heading_conversions.hpp"

namespace multipath_localization {
namespace {

using Imu = sensor_msgs::Imu;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Imu message_of(double yaw, double sigma) {
  std_msgs::Header header;
  header.stamp = ros::Time(3.0);
  return to_message(Heading{3.0, yaw, sigma * sigma}, header);
}

CheckedHeading read(const std::function<void(Imu&)>& spoil) {
  Imu message = message_of(2.0, 0.05);
  spoil(message);
  return to_heading(message, {}, Eigen::Quaterniond::Identity());
}

TEST(ToHeading, ReadsTheYaw) {
  const CheckedHeading checked = read([](Imu&) {});
  EXPECT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_EQ(checked.heading.stamp, 3.0);
  EXPECT_NEAR(checked.heading.yaw, 2.0, 1e-12);
  EXPECT_NEAR(checked.heading.variance, 0.0025, 1e-12);
  EXPECT_NEAR(declared_heading_sigma(message_of(2.0, 0.05)), 0.05, 1e-12);
}

TEST(ToHeading, ReadsItOfARobotThatLeansAndASensorThatIsTurned) {
  using Eigen::AngleAxisd;
  const Eigen::Quaterniond in_base(AngleAxisd(-0.5 * kPi, Eigen::Vector3d::UnitZ()) *
                                   AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
  const Eigen::Quaterniond base(AngleAxisd(2.0, Eigen::Vector3d::UnitZ()) *
                                AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
  const Eigen::Quaterniond sensor = base * in_base;
  Imu message = message_of(0.0, 0.05);
  message.orientation.w = sensor.w();
  message.orientation.x = sensor.x();
  message.orientation.y = sensor.y();
  message.orientation.z = sensor.z();
  EXPECT_NEAR(to_heading(message, {}, in_base).heading.yaw, 2.0, 1e-9);
}

TEST(ToHeading, TakesTheDefaultWhereNothingIsDeclared) {
  const CheckedHeading checked = read([](Imu& m) { m.orientation_covariance.fill(0.0); });
  EXPECT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_NEAR(std::sqrt(checked.heading.variance), HeadingParameters().default_sigma, 1e-12);
  EXPECT_TRUE(std::isnan(declared_heading_sigma(message_of(0.0, 0.0))));
}

TEST(ToHeading, RefusesWithAReason) {
  EXPECT_EQ(read([](Imu& m) { m.header.stamp = ros::Time(); }).reason, Reason::kZeroStamp);
  EXPECT_EQ(read([](Imu& m) { m.header.frame_id = std::string(300, 'x'); }).reason, Reason::kInvalidFrame);
  EXPECT_EQ(read([](Imu& m) { m.orientation_covariance[0] = -1.0; }).reason, Reason::kUnused);
  EXPECT_EQ(read([](Imu& m) { m.orientation.z = kNan; }).reason, Reason::kInvalidOrientation);
  EXPECT_EQ(read([](Imu& m) { m.orientation = {}; }).reason, Reason::kInvalidOrientation);
  EXPECT_EQ(read([](Imu& m) { m.orientation_covariance[8] = kNan; }).reason, Reason::kInvalidCovariance);
  EXPECT_EQ(read([](Imu& m) { m.orientation_covariance[8] = -0.1; }).reason, Reason::kInvalidCovariance);
}

TEST(ToHeading, ReadsThePoseOfADriverAsOneOfTheBase) {
  geometry_msgs::PoseWithCovarianceStamped pose;
  pose.header.stamp = ros::Time(3.0);
  pose.header.frame_id = "map";
  pose.pose.pose = to_message(Pose2{10.0, 20.0, 1.0});
  pose.pose.covariance[35] = 0.01;
  const Imu alone = orientation_alone(pose);
  EXPECT_TRUE(alone.header.frame_id.empty());
  const CheckedHeading checked = to_heading(alone, {}, Eigen::Quaterniond::Identity());
  EXPECT_NEAR(checked.heading.yaw, 1.0, 1e-12);
  EXPECT_NEAR(checked.heading.variance, 0.01, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
