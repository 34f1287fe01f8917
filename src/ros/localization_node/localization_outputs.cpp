#include "ros/localization_node/localization_outputs.hpp"

#include <visualization_msgs/MarkerArray.h>

#include <cmath>

#include "ros/localization_node/estimate_messages.hpp"
#include "ros/localization_node/localization_markers.hpp"

namespace multipath_localization {

LocalizationOutputs::LocalizationOutputs(ros::NodeHandle node, ros::NodeHandle private_node,
                                         const LocalizationParameters& parameters)
    : frames_(parameters.frames),
      parameters_(parameters.outputs),
      odometry_(node.advertise<nav_msgs::Odometry>("odometry/filtered_map", 1000)),
      pose_(node.advertise<geometry_msgs::PoseWithCovarianceStamped>("pose", 1000)),
      cloud_(node.advertise<geometry_msgs::PoseArray>("particlecloud", 2, true)),
      gps_odometry_(node.advertise<nav_msgs::Odometry>("odometry/gps", 10)),
      gps_filtered_(node.advertise<sensor_msgs::NavSatFix>("gps/filtered", 50)),
      bias_(private_node.advertise<GnssBias>("bias", 10)),
      report_(private_node.advertise<FixReport>("fix_report", 1000)),
      state_(node.advertise<LocalizationState>("localization/state", 10, true)),
      markers_(private_node.advertise<visualization_msgs::MarkerArray>("markers", 2)),
      trail_(static_cast<std::size_t>(parameters_.path_length), parameters_.path_spacing) {
  if (parameters_.path_length > 0) path_ = node.advertise<nav_msgs::Path>("path", 2);
}

std_msgs::Header LocalizationOutputs::in_map(const ros::Time& stamp) const {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = frames_.map_frame;
  return header;
}

void LocalizationOutputs::publish(const Localizer& localizer, const PoseEstimate& estimate,
                                  const ReadOdometry& odometry, const LocalFrame& map) {
  const std_msgs::Header header = in_map(odometry.message.header.stamp);
  odometry_.publish(to_odometry(estimate, odometry, frames_.map_frame, frames_.base_link_frame));
  if (pose_.getNumSubscribers() > 0) {
    geometry_msgs::PoseWithCovarianceStamped pose;
    pose.header = header;
    pose.pose = to_message(estimate, odometry.tilt);
    pose_.publish(pose);
  }
  const Trust trust = localizer.state();
  if (gps_filtered_.getNumSubscribers() > 0) {
    std_msgs::Header at_base = header;
    at_base.frame_id = frames_.base_link_frame;
    gps_filtered_.publish(to_nav_sat_fix(estimate, trust, map, at_base));
  }
  if (path_) trail_.add(header, to_message(estimate.pose));
  const double since_picture = header.stamp.toSec() - last_picture_;
  const bool due = since_picture < 0.0 || since_picture >= 1.0 / parameters_.cloud_rate;
  publish_changed_state(localizer, header.stamp);
  if (due) publish_picture(localizer, estimate, header.stamp);
}

void LocalizationOutputs::publish_picture(const Localizer& localizer, const PoseEstimate& estimate,
                                          const ros::Time& stamp) {
  last_picture_ = stamp.toSec();
  publish_state(localizer, stamp);
  const auto max_poses = static_cast<std::size_t>(parameters_.max_cloud_poses);
  LocalizationPicture picture{in_map(stamp), estimate, localizer.hypotheses(), last_fix_,
                              std::string(to_string(localizer.state()))};
  cloud_.publish(to_pose_array(picture.hypotheses, max_poses, picture.header));
  if (path_ && path_.getNumSubscribers() > 0) path_.publish(trail_.path());
  if (markers_.getNumSubscribers() > 0) markers_.publish(to_markers(picture, max_poses));
}

void LocalizationOutputs::publish_changed_state(const Localizer& localizer, const ros::Time& stamp) {
  if (localizer.state() != last_state_) publish_state(localizer, stamp);
}

void LocalizationOutputs::publish_state(const Localizer& localizer, const ros::Time& stamp) {
  last_state_ = localizer.state();
  state_.publish(to_state(localizer, in_map(stamp)));
}

void LocalizationOutputs::publish_fixes(const Measurement& measurement, const GnssMessage& message) {
  if (const auto* fix = std::get_if<GnssFix>(&measurement)) publish_fix(*fix, header_of(message));
  if (const auto* two = std::get_if<DualAntennaFix>(&measurement)) {
    const auto& pair = std::get<FixPair>(message);
    publish_fix(two->right, pair.right.header);
    publish_fix(two->left, pair.left.header);
  }
}

void LocalizationOutputs::publish_fix(const GnssFix& fix, const std_msgs::Header& header) {
  last_fix_ = fix;
  gps_odometry_.publish(to_odometry(fix, header, frames_.map_frame));
}

void LocalizationOutputs::publish_bias(const PoseEstimate& estimate, const ros::Time& stamp) const {
  if (estimate.valid && finite(estimate)) bias_.publish(to_bias(estimate, in_map(stamp)));
}

void LocalizationOutputs::clear() {
  last_fix_.reset();
  last_state_.reset();
  last_picture_ = 0.0;
  trail_.clear();
}

}  // namespace multipath_localization
