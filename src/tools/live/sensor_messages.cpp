#include "tools/live/sensor_messages.hpp"

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kNoise = 0.3;  ///< of fixes [m]

}  // namespace

nav_msgs::Odometry SensorMessages::odometry(const OdometryIncrement& u, const ros::Time& stamp) {
  base_in_odom_ = base_in_odom_ * displacement(u);
  nav_msgs::Odometry message;
  message.header.stamp = stamp;
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.pose.pose = to_message(base_in_odom_);
  message.twist.twist.linear.x = u.speed;
  message.twist.twist.linear.y = u.lateral_speed;
  message.twist.twist.angular.z = u.yaw_rate;
  return message;
}

sensor_msgs::NavSatFix SensorMessages::fix(const Eigen::Vector2d& position, const ros::Time& stamp,
                                           RandomStream& random) const {
  GnssFix fix;
  const double east = random.normal();
  fix.position = position + kNoise * Eigen::Vector2d(east, random.normal());
  fix.covariance = kNoise * kNoise * Eigen::Matrix2d::Identity();
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = "base_link";
  return to_message(fix, map_, header);
}

}  // namespace multipath_localization
