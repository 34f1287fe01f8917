#include "ros/localization_node/tf_watch.hpp"

#include <ros/console.h>
#include <ros/this_node.h>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kStillThere = 5.0;  ///< [s]
constexpr double kTellEvery = 5.0;   ///< [s]

}  // namespace

TfWatch::TfWatch(ros::NodeHandle node, const FrameParameters& frames) : frames_(frames), antennas_(frames) {
  using Event = ros::MessageEvent<tf2_msgs::TFMessage const>;
  const boost::function<void(const Event&)> on_tf = [this](const Event& event) {
    on_transforms(event, false);
  };
  const boost::function<void(const Event&)> on_static = [this](const Event& event) {
    on_transforms(event, true);
  };
  tf_ = node.subscribe<tf2_msgs::TFMessage>("/tf", 100, on_tf, ros::VoidConstPtr(),
                                            ros::TransportHints().tcpNoDelay());
  tf_static_ = node.subscribe<tf2_msgs::TFMessage>("/tf_static", 100, on_static);
}

void TfWatch::on_transforms(const ros::MessageEvent<tf2_msgs::TFMessage const>& event, bool is_static) {
  const std::string& broadcaster = event.getPublisherName();
  if (broadcaster == ros::this_node::getName()) return;
  for (const geometry_msgs::TransformStamped& transform : event.getConstMessage()->transforms) {
    const std::string child = without_slash(transform.child_frame_id);
    if (!antennas_.add(transform, is_static)) {
      ROS_WARN_THROTTLE(
          kTellEvery,
          "transform to %s by %s refused: its names are empty, equal or too long, its numbers are "
          "no pose, or it is stamped %.0f s",
          shown(child).c_str(), broadcaster.c_str(), transform.header.stamp.toSec());
      continue;
    }
    if (child == frames_.odom_frame || child == frames_.base_link_frame) {
      broadcasters_[child] = {broadcaster, ros::WallTime::now(), is_static};
    }
  }
}

std::string TfWatch::broadcaster_of(const std::string& child) const {
  const auto found = broadcasters_.find(child);
  if (found == broadcasters_.end()) return "";
  const Broadcaster& broadcaster = found->second;
  const bool still_there =
      broadcaster.is_static || (ros::WallTime::now() - broadcaster.seen).toSec() < kStillThere;
  return still_there ? broadcaster.name : "";
}

}  // namespace multipath_localization
