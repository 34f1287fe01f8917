#include "ros/localization_node/map_to_odom.hpp"

#include "ros/messages/tilt_conversions.hpp"

namespace multipath_localization {

MapToOdom::MapToOdom(const FrameParameters& frames, const OutputParameters& outputs)
    : frames_(frames), outputs_(outputs), slew_(outputs.slew) {}

void MapToOdom::send(const Pose2& odom_in_map, const Pose2& base_in_odom, const ros::Time& stamp,
                     const ros::Time& arrival) {
  if (!outputs_.publish_tf) return;
  odom_in_map_ = slew_.follow(odom_in_map, base_in_odom, stamp.toSec());
  odometry_stamp_ = stamp;
  arrival_ = arrival;
  broadcast(stamp + ros::Duration(outputs_.transform_tolerance));
}

void MapToOdom::keep_up(const ros::Time& now, double longest_silence) {
  const double silence = now.toSec() - arrival_.toSec();
  if (!odom_in_map_ || silence < 0.0 || silence > longest_silence) return;
  const ros::Time stamp = odometry_stamp_ + ros::Duration(silence + outputs_.transform_tolerance);
  if (stamp.toSec() - last_sent_.toSec() > 0.5 / outputs_.tf_rate) broadcast(stamp);
}

void MapToOdom::broadcast(const ros::Time& stamp) {
  if (stamp <= last_sent_) return;
  last_sent_ = stamp;
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = frames_.map_frame;
  message.child_frame_id = frames_.odom_frame;
  message.transform = to_transform(*odom_in_map_);
  broadcaster_.sendTransform(message);
}

void MapToOdom::send_odometry(const Pose2& base_in_odom, const Tilt& tilt, const ros::Time& stamp) {
  if (stamp <= last_odometry_sent_) return;
  last_odometry_sent_ = stamp;
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = frames_.odom_frame;
  message.child_frame_id = frames_.base_link_frame;
  message.transform = to_transform(base_in_odom);
  message.transform.rotation = to_orientation(base_in_odom.yaw, tilt);
  broadcaster_.sendTransform(message);
}

void MapToOdom::clear() {
  odom_in_map_.reset();
  jump();
  last_sent_ = last_odometry_sent_ = ros::Time();
}

}  // namespace multipath_localization
