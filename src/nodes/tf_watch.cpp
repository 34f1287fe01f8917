#include "nodes/tf_watch.hpp"

#include <ros/console.h>
#include <ros/this_node.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <cmath>

#include "nodes/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kStillThere = 5.0;  ///< [s]
constexpr double kTellEvery = 5.0;   ///< [s]

/// Whether tf2's buffer can take it: it refuses NaN and quaternions not of length one by itself, but throws
/// on stamps near the end of ros::Time.
bool usable(const geometry_msgs::TransformStamped& transform, bool is_static) {
  return is_short(transform.child_frame_id) && is_short(transform.header.frame_id) &&
         (is_static || transform.header.stamp.toSec() <= kLatestStamp);
}

}  // namespace

TfWatch::TfWatch(ros::NodeHandle node, const FrameParameters& frames) : frames_(frames) {
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
    if (!usable(transform, is_static)) {
      ROS_WARN_THROTTLE(kTellEvery,
                        "transform to %s by %s refused: its names are too long or it is stamped %.0f s",
                        shown(child).c_str(), broadcaster.c_str(), transform.header.stamp.toSec());
      continue;
    }
    if (child == frames_.odom_frame || child == frames_.base_link_frame) {
      broadcasters_[child] = {broadcaster, ros::WallTime::now(), is_static};
    }
    if (is_static) static_transforms_[child] = transform;
    add(transform, broadcaster, is_static);
  }
}

void TfWatch::add(const geometry_msgs::TransformStamped& transform, const std::string& broadcaster,
                  bool is_static) {
  if (!buffer_.setTransform(transform, broadcaster, is_static)) return;
  parents_[without_slash(transform.child_frame_id)] = without_slash(transform.header.frame_id);
}

std::string TfWatch::broadcaster_of(const std::string& child) const {
  const auto found = broadcasters_.find(child);
  if (found == broadcasters_.end()) return "";
  const Broadcaster& broadcaster = found->second;
  const bool still_there =
      broadcaster.is_static || (ros::WallTime::now() - broadcaster.seen).toSec() < kStillThere;
  return still_there ? broadcaster.name : "";
}

std::optional<Eigen::Vector2d> TfWatch::origin_in_base(const std::string& frame) {
  const std::string name = without_slash(frame);
  if (name.empty() || name == frames_.base_link_frame) return Eigen::Vector2d::Zero();
  const auto known = found_.find(name);
  if (known != found_.end()) return known->second;
  if (!rides_on_robot(name)) return {};
  try {
    const auto origin =
        buffer_.lookupTransform(frames_.base_link_frame, name, ros::Time()).transform.translation;
    if (!std::isfinite(origin.x) || !std::isfinite(origin.y)) return {};
    return found_[name] = Eigen::Vector2d(origin.x, origin.y);
  } catch (const tf2::TransformException&) {
    return {};
  }
}

std::string TfWatch::described(const std::string& frame) const {
  return frame + (rides_on_robot(without_slash(frame)) ? "" : " (which does not ride on the robot)");
}

std::vector<std::string> TfWatch::with_ancestors(const std::string& frame) const {
  std::vector<std::string> line = {frame};
  auto next = parents_.find(frame);
  while (next != parents_.end() && line.size() < tf2::BufferCore::MAX_GRAPH_DEPTH) {
    line.push_back(next->second);
    next = parents_.find(line.back());
  }
  return line;
}

bool TfWatch::rides_on_robot(const std::string& frame) const {
  const auto stays = [this](const std::string& f) {
    return f == frames_.odom_frame || f == frames_.map_frame;
  };
  if (stays(frame)) return false;
  const std::vector<std::string> line = with_ancestors(frame);
  bool rides = true;
  for (const std::string& carrier : with_ancestors(frames_.base_link_frame)) {
    const auto joint = std::find(line.begin(), line.end(), carrier);
    rides = rides && !stays(carrier);
    if (joint != line.end()) return rides && std::none_of(line.begin(), joint, stays);
    rides = rides && static_transforms_.count(carrier) > 0;
  }
  return true;
}

void TfWatch::clear() {
  buffer_.clear();
  parents_.clear();
  for (const auto& [child, transform] : static_transforms_) add(transform, "static", true);
}

}  // namespace multipath_localization
