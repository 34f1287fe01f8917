#pragma once

#include <sensor_msgs/JointState.h>

#include <optional>
#include <string>
#include <vector>

#include "models/motion/wheel_odometer.hpp"

namespace multipath_localization {

/// Names of joints, as parameters give them.
struct WheelJoints {
  std::vector<std::string> left;
  std::vector<std::string> right;
  std::vector<std::string> steering;
};

/// The words of a text that spaces part.
std::vector<std::string> words(const std::string& text);

/// What a message says of the wheels.
struct JointsRead {
  WheelReadings readings;            ///< with nothing told of those that are missing
  std::vector<std::string> missing;  ///< that the message does not name, or whose numbers it does not hold
  bool names_any = false;            ///< not the message of an arm beside it
};

/// Reads the joints in whatever order they stand. Lists of the message that are shorter than its names tell
/// nothing.
JointsRead read_joints(const sensor_msgs::JointState& message, const WheelJoints& joints);

}  // namespace multipath_localization
