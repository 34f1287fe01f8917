#pragma once

#include <string>

#include "models/motion/wheel_odometer.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "ros/wheel_odometry_node/wheel_joints.hpp"

namespace multipath_localization {

/// Where wheels are read.
enum class WheelSource { kJoints, kAckermann };

/// Parameters of wheel_odometry_node.
struct WheelOdometryParameters {
  WheelSource source = WheelSource::kJoints;
  std::string left_wheels = "left_wheel_joint";
  std::string right_wheels = "right_wheel_joint";
  std::string steering_joints;
  WheelGeometry geometry;
  WheelLimits limits;
  std::string odom_frame = "odom";
  std::string base_link_frame = "base_link";

  void fields(ParameterVisitor& field);
  /// Throws ParameterError where a measure or a joint that the source takes is not given.
  void require_all() const;
  [[nodiscard]] WheelJoints joints() const;
};

}  // namespace multipath_localization
