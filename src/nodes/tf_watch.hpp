#pragma once

#include <ros/node_handle.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nodes/localization_parameters.hpp"

namespace multipath_localization {

/// What other nodes say on /tf: where antennas are on the base, and who else broadcasts our transforms.
class TfWatch {
 public:
  TfWatch(ros::NodeHandle node, const FrameParameters& frames);

  /// Origin of `frame` in the base's frame [m], the rotation is not looked at. An empty frame and the base's
  /// own give zero; nothing when tf does not know or the frame does not ride on the robot. What was found
  /// once is kept: an antenna does not move.
  std::optional<Eigen::Vector2d> origin_in_base(const std::string& frame);

  /// The name of a frame that has no origin in the base's, with the reason where tf tells one.
  [[nodiscard]] std::string described(const std::string& frame) const;

  /// The other node that gives odom_frame or base_link_frame a parent, empty for none in the last seconds.
  [[nodiscard]] std::string broadcaster_of_odom() const { return broadcaster_of(frames_.odom_frame); }
  [[nodiscard]] std::string broadcaster_of_base() const { return broadcaster_of(frames_.base_link_frame); }

  /// Forgets what was timed, as when the clock has gone back.
  void clear();

 private:
  struct Broadcaster {
    std::string name;
    ros::WallTime seen;
    bool is_static = false;
  };

  [[nodiscard]] std::string broadcaster_of(const std::string& child) const;
  /// That frame and those above it, up to the root of the tree.
  [[nodiscard]] std::vector<std::string> with_ancestors(const std::string& frame) const;
  /// False for odom and map and where tf joins the frame and the base by either, or by a transform above the
  /// base that is not static: it moves the robot.
  [[nodiscard]] bool rides_on_robot(const std::string& frame) const;
  void on_transforms(const ros::MessageEvent<tf2_msgs::TFMessage const>& event, bool is_static);
  void add(const geometry_msgs::TransformStamped& transform, const std::string& broadcaster, bool is_static);

  FrameParameters frames_;
  tf2::BufferCore buffer_;
  std::map<std::string, geometry_msgs::TransformStamped> static_transforms_;  ///< by child frame
  std::map<std::string, std::string> parents_;  ///< by child frame, of the transforms that the buffer took
  std::map<std::string, Eigen::Vector2d> found_;
  std::map<std::string, Broadcaster> broadcasters_;  ///< by child frame: odom_frame and base_link_frame
  ros::Subscriber tf_;
  ros::Subscriber tf_static_;
};

}  // namespace multipath_localization
