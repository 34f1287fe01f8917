#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/NavSatFix.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <string>

#include "../models/sky.hpp"
#include "multipath_localization/core/geodesy.hpp"
#include "ros/messages/epoch_conversions.hpp"

namespace multipath_localization {

inline const Geodetic kDatum{48.0, 11.0, 500.0};

struct Recording {
  bool with_antenna = true;  ///< the static transform to it, at the base
  bool with_fix = true;
  bool with_epoch = false;
  bool with_pair = false;    ///< of antennas half a metre to the left and to the right
  std::string prefix = "/";  ///< of topics
  bool with_truth = true;
  bool with_shadow = true;
  bool with_heading = true;
  double arrival_delay = 0.0;       ///< of fixes [s]
  Eigen::Vector2d bias{8.0, -3.0};  ///< in shadow, which is the second half
};

template <class Message>
Message stamped(double stamp) {
  Message message;
  message.header.stamp.fromSec(stamp);
  return message;
}

inline nav_msgs::Odometry odometry_at(double stamp) {
  auto message = stamped<nav_msgs::Odometry>(stamp);
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.pose.pose.orientation.w = 1.0;
  message.twist.twist.linear.x = 1.0;
  return message;
}

inline geometry_msgs::PoseStamped truth_at_time(double stamp, double north, bool with_heading) {
  auto message = stamped<geometry_msgs::PoseStamped>(stamp);
  message.header.frame_id = "map";
  message.pose.position.x = 5.0;
  message.pose.position.y = north;
  message.pose.orientation.z = with_heading ? std::sqrt(0.5) : 0.0;
  message.pose.orientation.w = with_heading ? std::sqrt(0.5) : 1.0;
  return message;
}

inline sensor_msgs::NavSatFix fix_at(double stamp, const Eigen::Vector2d& position) {
  const Geodetic point = LocalFrame(kDatum).to_geodetic(position);
  auto message = stamped<sensor_msgs::NavSatFix>(stamp);
  message.header.frame_id = "gps";
  message.latitude = point.latitude_deg;
  message.longitude = point.longitude_deg;
  message.altitude = point.altitude;
  message.position_covariance[0] = message.position_covariance[4] = 4.0;
  message.position_covariance_type = sensor_msgs::NavSatFix::COVARIANCE_TYPE_DIAGONAL_KNOWN;
  return message;
}

/// Of an antenna at that position whose clock is 100 km off.
inline GnssEpoch epoch_at(double stamp, const Eigen::Vector2d& position) {
  PseudorangeEpoch epoch;
  epoch.observations = observed(open_sky(), {position.x(), position.y(), 0.0}, -1e5, -1e5);
  GnssEpoch message = to_message(epoch, LocalFrame(kDatum), {});
  message.header.stamp.fromSec(stamp);
  message.header.frame_id = "gps";
  return message;
}

inline tf2_msgs::TFMessage antenna_at(double x, double y, const std::string& frame = "gps") {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  geometry_msgs::TransformStamped& transform = message.transforms.front();
  transform.header.frame_id = "base_link";
  transform.child_frame_id = frame;
  transform.transform.translation.x = x;
  transform.transform.translation.y = y;
  transform.transform.rotation.w = 1.0;
  return message;
}

inline void write_pair(rosbag::Bag& bag, double stamp, const Eigen::Vector2d& position) {
  auto left = fix_at(stamp, position + Eigen::Vector2d(-0.5, 0.0));
  auto right = fix_at(stamp, position + Eigen::Vector2d(0.5, 0.0));
  left.header.frame_id = "gps_left";
  right.header.frame_id = "gps_right";
  bag.write("/gps/left/fix", ros::Time(stamp), left);
  if (stamp != 1003.0) bag.write("/gps/right/fix", ros::Time(stamp), right);
}

/// A copy of a bag in which the messages of a topic are as if of another version of their type.
inline std::string with_other_version(const std::string& file, const std::string& topic,
                                      const std::string& md5sum = "*") {
  const std::string copy = testing::TempDir() + "other_version_under_test.bag";
  const rosbag::Bag in(file);
  rosbag::Bag out(copy, rosbag::bagmode::Write);
  for (const rosbag::MessageInstance& message : rosbag::View(in)) {
    const auto header = boost::make_shared<ros::M_string>(*message.getConnectionHeader());
    if (message.getTopic() == topic) (*header)["md5sum"] = md5sum;
    out.write(message.getTopic(), message.getTime(), message, header);
  }
  return copy;
}

/// Twenty seconds north at 1 m/s from (5, 0), in shadow from the tenth on; every topic at 1 Hz, the right one
/// of two antennas without a fix in the third.
inline std::string record(const Recording& recording) {
  const std::string file = testing::TempDir() + "bag_drive_under_test.bag";
  rosbag::Bag bag(file, rosbag::bagmode::Write);
  const auto name = [&](const std::string& topic) { return recording.prefix + topic; };
  if (recording.with_antenna) bag.write("/tf_static", ros::Time(1000.0), antenna_at(0.0, 0.0));
  if (recording.with_pair) {
    bag.write("/tf_static", ros::Time(1000.0), antenna_at(0.0, 0.5, "gps_left"));
    bag.write("/tf_static", ros::Time(1000.0), antenna_at(0.0, -0.5, "gps_right"));
  }
  for (int i = 0; i <= 20; ++i) {
    const double stamp = 1000.0 + i;
    const ros::Time now(stamp);
    const bool shadow = i >= 10;
    bag.write(name("odom"), now, odometry_at(stamp));
    const Eigen::Vector2d error = shadow ? recording.bias : Eigen::Vector2d(0.0, 0.0);
    const Eigen::Vector2d position = Eigen::Vector2d(5.0, i) + error;
    const ros::Time arrival(stamp + recording.arrival_delay);
    if (recording.with_fix) bag.write(name("gps/fix"), arrival, fix_at(stamp, position));
    if (recording.with_epoch) bag.write(name("gnss/epoch"), arrival, epoch_at(stamp, position));
    if (recording.with_pair) write_pair(bag, stamp, position);
    if (recording.with_truth) bag.write(name("truth"), now, truth_at_time(stamp, i, recording.with_heading));
    if (!recording.with_shadow) continue;
    auto flag = stamped<geometry_msgs::Vector3Stamped>(stamp);
    flag.vector.z = shadow ? 1.0 : 0.0;
    bag.write(name("truth/bias"), now, flag);
  }
  bag.close();
  return file;
}

}  // namespace multipath_localization
