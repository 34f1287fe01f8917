#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ros/inputs/frame_parameters.hpp"

namespace multipath_localization {

/// The pose in space that a transform is; nothing where a number is not finite or the quaternion is not of
/// length one.
std::optional<Eigen::Isometry3d> to_isometry(const geometry_msgs::Transform& child_in_parent);

/// The tree of frames as /tf and /tf_static tell it, and where on the robot its antennas are. Names go with
/// or without a leading slash. What was told once holds until it is told otherwise, whatever its stamp.
///
/// An antenna rides on the robot where neither it, nor the base, nor a frame between them stays on the
/// ground: map, odom, earth, and any frame with one of these words, `world` or `utm` in its name
/// ("robot_odom"). On which of the two topics a joint is told does not matter. But an antenna that has moved
/// on the base by more than 20 cm since it was first asked for is no mast: it is on a joint that turns, or on
/// the ground beside a robot that drives; and one over 20 m from the base is on none. A static transform told
/// anew is a correction.
class AntennaFrames {
 public:
  explicit AntennaFrames(const FrameParameters& frames) : frames_(frames) {}

  /// The robot's frames are others than it was told.
  void set_frames(const FrameParameters& frames);

  /// Takes a transform, unless its names are too long or its numbers make none. Returns whether it did.
  bool add(const geometry_msgs::TransformStamped& transform, bool is_static);

  /// Origin of a frame in the base's frame [m], the rotation is not looked at. An empty frame and the base's
  /// own give zero; nothing where it does not ride on the robot or no transform joins the two.
  std::optional<Eigen::Vector2d> in_base(const std::string& frame);

  /// How high the origin of a frame is above the base's, along the base's z axis [m]. An empty frame and the
  /// base's own give zero, as does one that no transform joins to it.
  [[nodiscard]] double height_in_base(const std::string& frame) const;

  /// How a frame that rides on the robot is turned against the base, wherever it is. An empty frame and the
  /// base's own are not; nothing where no transform joins the two.
  [[nodiscard]] std::optional<Eigen::Quaterniond> rotation_in_base(const std::string& frame) const;

  /// Whether transforms yet to come may place a frame that is not known on the base: none has joined it so
  /// far.
  [[nodiscard]] bool may_come(const std::string& frame) const;

  /// The name of a frame that is not known on the base, with the reason where there is one.
  [[nodiscard]] std::string described(const std::string& frame) const;

  /// The pose of a frame in another; nothing where no transforms join them.
  [[nodiscard]] std::optional<Eigen::Isometry3d> pose(const std::string& frame,
                                                      const std::string& reference) const;

 private:
  struct Joint {
    std::string parent;
    Eigen::Isometry3d child_in_parent = Eigen::Isometry3d::Identity();
  };
  /// That frame and those above it, up to the root of the tree.
  [[nodiscard]] std::vector<std::string> with_ancestors(const std::string& frame) const;
  /// The frames between two, themselves and the one that joins them included; empty where none does.
  [[nodiscard]] std::vector<std::string> between(const std::string& one, const std::string& other) const;
  [[nodiscard]] Eigen::Isometry3d in_root(const std::string& frame) const;
  [[nodiscard]] bool stays_on_ground(const std::string& frame) const;
  /// Whether the transforms by now leave it on the robot.
  [[nodiscard]] bool rides(const std::string& frame) const;

  void forget_found();

  FrameParameters frames_;
  std::map<std::string, Joint> joints_;                 ///< by child
  std::map<std::string, Eigen::Vector2d> first_found_;  ///< by frame
  std::set<std::string> moving_;
};

}  // namespace multipath_localization
