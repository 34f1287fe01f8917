#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "ros/messages/velocity_conversions.hpp"

namespace multipath_localization {
namespace {

using Message = geometry_msgs::TwistWithCovarianceStamped;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Message message_of(double east, double north, double sigma) {
  Message message;
  message.header.stamp = ros::Time(3.0);
  message.twist.twist.linear.x = east;
  message.twist.twist.linear.y = north;
  message.twist.covariance[0] = message.twist.covariance[7] = sigma * sigma;
  return message;
}

CheckedVelocity read(const std::function<void(Message&)>& spoil) {
  Message message = message_of(1.0, -2.0, 0.1);
  spoil(message);
  return to_velocity(message, {}, Eigen::Vector2d(0.3, 0.1));
}

TEST(ToVelocity, ReadsEastAndNorth) {
  const CheckedVelocity checked = read([](Message&) {});
  EXPECT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_EQ(checked.velocity.velocity, Eigen::Vector2d(1.0, -2.0));
  EXPECT_NEAR(checked.velocity.covariance(0, 0), 0.01, 1e-12);
  EXPECT_EQ(checked.velocity.antenna_in_base, Eigen::Vector2d(0.3, 0.1));
  EXPECT_NEAR(declared_sigma(message_of(1.0, 1.0, 0.1)), 0.1, 1e-12);
}

TEST(ToVelocity, TakesTheDefaultWhereNothingIsDeclared) {
  const CheckedVelocity checked = read([](Message& m) { m.twist.covariance.fill(0.0); });
  EXPECT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_NEAR(std::sqrt(checked.velocity.covariance(1, 1)), VelocityParameters().default_sigma, 1e-12);
}

TEST(ToVelocity, DoesNotBelieveZeroWithoutCovariance) {
  EXPECT_EQ(to_velocity(message_of(0.0, 0.0, 0.0), {}).reason, Reason::kRepeated);
  EXPECT_EQ(to_velocity(message_of(0.0, 0.0, 0.1), {}).reason, Reason::kAccepted);
}

TEST(ToVelocity, RefusesWithAReason) {
  EXPECT_EQ(read([](Message& m) { m.header.stamp = ros::Time(); }).reason, Reason::kZeroStamp);
  EXPECT_EQ(read([](Message& m) { m.twist.twist.linear.y = kNan; }).reason, Reason::kNotFinite);
  EXPECT_EQ(read([](Message& m) { m.twist.twist.linear.y = 400.0; }).reason, Reason::kTooFast);
  EXPECT_EQ(read([](Message& m) { m.twist.covariance[7] = -1.0; }).reason, Reason::kInvalidCovariance);
  EXPECT_EQ(read([](Message& m) { m.twist.covariance[1] = kNan; }).reason, Reason::kInvalidCovariance);
  EXPECT_EQ(read([](Message& m) { m.header.frame_id = std::string(300, 'x'); }).reason,
            Reason::kInvalidFrame);
  EXPECT_EQ(read([](Message& m) { m.twist.twist.linear.z = kNan; }).reason, Reason::kAccepted);
}

TEST(ToVelocity, ReadsBackWhatIsWritten) {
  GnssVelocity velocity;
  velocity.stamp = 3.0;
  velocity.velocity = {1.5, -0.5};
  velocity.covariance << 0.04, 0.01, 0.01, 0.09;
  std_msgs::Header header;
  header.stamp = ros::Time(3.0);
  const CheckedVelocity back = to_velocity(to_message(velocity, header), {});
  EXPECT_EQ(back.velocity.velocity, velocity.velocity);
  EXPECT_TRUE(back.velocity.covariance.isApprox(velocity.covariance));
}

TEST(ToVelocity, ReadsABareTwistAsOneWithoutCovariance) {
  geometry_msgs::TwistStamped bare;
  bare.header.stamp = ros::Time(3.0);
  bare.twist.linear.x = 2.0;
  const CheckedVelocity checked = to_velocity(without_covariance(bare), {});
  EXPECT_EQ(checked.velocity.velocity, Eigen::Vector2d(2.0, 0.0));
  EXPECT_NEAR(std::sqrt(checked.velocity.covariance(0, 0)), VelocityParameters().default_sigma, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
