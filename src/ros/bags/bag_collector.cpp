#include "ros/bags/bag_collector.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Vector3Stamped.h>

#include <algorithm>

#include "ros/map/datum.hpp"
#include "ros/messages/earth_frame.hpp"

namespace multipath_localization {

void BagCollector::take(const rosbag::MessageInstance& message) {
  const std::string& topic = message.getTopic();
  const bool is_static = without_slash(topic) == "tf_static";
  if (is_static || without_slash(topic) == "tf") add(read<tf2_msgs::TFMessage>(message), is_static);
  if (topic == topics_.odometry) add(read<nav_msgs::Odometry>(message));
  if (topic == topics_.truth) take_truth(message);
  if (topic == topics_.shadow) {
    const auto bias = read<geometry_msgs::Vector3Stamped>(message);
    truth_.add_shadow(bias.header.stamp.toSec(), bias.vector.z > 0.5);
  }
  if (topic == topics_.imu) add(read<sensor_msgs::Imu>(message));
  take_gnss(message);
}

template <class Message>
Message BagCollector::read(const rosbag::MessageInstance& message) const {
  if (const auto known = message.instantiate<Message>()) return *known;
  const std::string wanted = ros::message_traits::datatype<Message>();
  const std::string is = file_ + ": " + message.getTopic() + " is a " + message.getDataType();
  throw DriveError(message.getDataType() == wanted ? is + " of another version" : is + ", not a " + wanted);
}

std::optional<Geodetic> BagCollector::datum() const {
  const std::optional<Eigen::Isometry3d> map = antennas_.pose(truth_.frame(), kEarthFrame);
  return map ? datum_of(*map) : std::nullopt;
}

void BagCollector::add(const nav_msgs::Odometry& message) {
  if (!refusals_.passes(topics_.odometry, odometry_.add(message))) return;
  antennas_.set_frames({FrameParameters().map_frame, without_slash(message.header.frame_id),
                        without_slash(message.child_frame_id)});
}

void BagCollector::add(const sensor_msgs::Imu& message) {
  const CheckedYawRate checked = imu_.read(message);
  if (!refusals_.passes(topics_.imu, checked.reason)) return;
  yaw_rates_.push_back({checked.yaw_rate, odometry_.arrival(checked.yaw_rate.stamp)});
}

void BagCollector::add(const tf2_msgs::TFMessage& message, bool is_static) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    antennas_.add(transform, is_static);
  }
}

void BagCollector::take_truth(const rosbag::MessageInstance& message) {
  const auto add_pose = [this](const std_msgs::Header& header, const geometry_msgs::Pose& pose) {
    refusals_.passes(topics_.truth, truth_.add(header, pose));
  };
  if (message.getDataType() == ros::message_traits::datatype<nav_msgs::Odometry>()) {
    const auto odometry = read<nav_msgs::Odometry>(message);
    return add_pose(odometry.header, odometry.pose.pose);
  }
  const auto pose = read<geometry_msgs::PoseStamped>(message);
  add_pose(pose.header, pose.pose);
}

void BagCollector::take_gnss(const rosbag::MessageInstance& message) {
  const std::string& topic = message.getTopic();
  if (topic == topics_.velocity || topic == topics_.heading) take_by_type(message);
  if (topic == topics_.fix) measurements_.add(ReceiverFix(read<sensor_msgs::NavSatFix>(message)));
  const auto more = std::find(topics_.more_fixes.begin(), topics_.more_fixes.end(), topic);
  if (more != topics_.more_fixes.end()) {
    const auto receiver = static_cast<std::size_t>(more - topics_.more_fixes.begin()) + 1;
    measurements_.add(ReceiverFix(read<sensor_msgs::NavSatFix>(message), receiver));
  }
  if (topic == topics_.epoch) measurements_.add(read<GnssEpoch>(message));
  const auto add_antenna = [&](FixPairing::Side side) {
    measurements_.add(side, read<sensor_msgs::NavSatFix>(message));
  };
  if (topic == topics_.left) add_antenna(FixPairing::Side::kLeft);
  if (topic == topics_.right) add_antenna(FixPairing::Side::kRight);
}

void BagCollector::take_by_type(const rosbag::MessageInstance& message) {
  const std::string& type = message.getDataType();
  if (type == ros::message_traits::datatype<geometry_msgs::TwistStamped>()) {
    measurements_.add(without_covariance(read<geometry_msgs::TwistStamped>(message)));
  } else if (type == ros::message_traits::datatype<sensor_msgs::Imu>()) {
    measurements_.add(read<sensor_msgs::Imu>(message));
  } else if (type == ros::message_traits::datatype<geometry_msgs::PoseWithCovarianceStamped>()) {
    measurements_.add(orientation_alone(read<geometry_msgs::PoseWithCovarianceStamped>(message)));
  } else {
    measurements_.add(read<geometry_msgs::TwistWithCovarianceStamped>(message));
  }
}

}  // namespace multipath_localization
