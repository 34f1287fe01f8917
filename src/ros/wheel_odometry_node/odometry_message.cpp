#include "ros/wheel_odometry_node/odometry_message.hpp"

#include <algorithm>
#include <cmath>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kUnknownVariance = 1e6;   // of what wheels do not measure [m^2, rad^2 and so on]
constexpr double kSpeedShare = 0.05;       // of a tyre's radius by load and pressure, and of slip on a road
constexpr double kYawRateShare = 0.1;      // of where on its width a wheel touches the ground, and of skid
constexpr double kLeastSpeedSigma = 0.01;  // of one tick more or less in an interval [m/s]
constexpr double kLeastYawSigma = 0.01;    // [rad/s]

double variance(double share, double value, double least) {
  const double sigma = std::max(share * std::abs(value), least);
  return sigma * sigma;
}

}  // namespace

nav_msgs::Odometry to_odometry(const ros::Time& stamp, const OdometryIncrement& motion,
                               const Pose2& base_in_odom, const WheelOdometryParameters& parameters) {
  nav_msgs::Odometry message;
  message.header.stamp = stamp;
  message.header.frame_id = parameters.odom_frame;
  message.child_frame_id = parameters.base_link_frame;
  message.pose.pose = to_message(base_in_odom);
  message.twist.twist.linear.x = motion.speed;
  message.twist.twist.linear.y = motion.lateral_speed;
  message.twist.twist.angular.z = motion.yaw_rate;
  for (std::size_t i = 0; i < 6; ++i) {
    message.pose.covariance[7 * i] = message.twist.covariance[7 * i] = kUnknownVariance;
  }
  message.twist.covariance[0] = variance(kSpeedShare, motion.speed, kLeastSpeedSigma);
  message.twist.covariance[7] = variance(kYawRateShare, motion.lateral_speed, kLeastSpeedSigma);
  message.twist.covariance[35] = variance(kYawRateShare, motion.yaw_rate, kLeastYawSigma);
  return message;
}

}  // namespace multipath_localization
