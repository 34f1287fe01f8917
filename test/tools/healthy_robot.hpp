#pragma once

#include <string>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/random.hpp"
#include "ros/messages/conversions.hpp"
#include "tools/doctor/observations.hpp"

namespace multipath_localization {

/// A transform as somebody broadcasts it.
inline Broadcast broadcast(const std::string& parent, const std::string& child, const std::string& node,
                           double x = 0.0) {
  Broadcast result;
  result.node = node;
  result.transform.header.frame_id = parent;
  result.transform.child_frame_id = child;
  result.transform.transform.translation.x = x;
  result.transform.transform.rotation.w = 1.0;
  return result;
}

/// Two minutes of a robot that drives figures of eight at 1 m/s and has nothing wrong with it: fixes at 5 Hz
/// with 0.3 m of noise, odometry at 20 Hz.
inline Observations healthy_robot() {
  Observations seen;
  seen.types = {{"gps/fix", "sensor_msgs/NavSatFix"}, {"odom", "nav_msgs/Odometry"}};
  seen.transforms = {broadcast("odom", "base_link", "/base"), broadcast("base_link", "gps", "/antenna", 0.3)};
  const LocalFrame map(Geodetic{52.512345678, 13.412345678, 40.0});
  Pose2 pose;  // in map as in odom
  for (std::uint32_t i = 1; i <= 2400; ++i) {
    const double stamp = 1000.0 + 0.05 * i;
    const double yaw_rate = i % 1200 < 600 ? 0.1 : -0.1;
    pose = pose * displacement({stamp, 0.05, 1.0, yaw_rate});
    nav_msgs::Odometry odometry;
    odometry.header.stamp = ros::Time(stamp);
    odometry.header.frame_id = "odom";
    odometry.child_frame_id = "base_link";
    odometry.pose.pose = to_message(pose);
    odometry.twist.twist.linear.x = 1.0;
    odometry.twist.twist.angular.z = yaw_rate;
    seen.odometry.push_back({odometry, stamp + 0.01});
    if (i % 4 != 0) continue;
    RandomStream random(1, i, 0);
    GnssFix fix;
    fix.position = pose.position() + Eigen::Vector2d(0.3 * random.normal(), 0.3 * random.normal());
    fix.covariance = 0.09 * Eigen::Matrix2d::Identity();
    std_msgs::Header header;
    header.stamp = ros::Time(stamp);
    header.frame_id = "gps";
    seen.fixes.push_back({to_message(fix, map, header), stamp + 0.1});
  }
  return seen;
}

}  // namespace multipath_localization
