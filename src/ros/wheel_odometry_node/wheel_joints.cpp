#include "ros/wheel_odometry_node/wheel_joints.hpp"

#include <algorithm>
#include <sstream>

namespace multipath_localization {

namespace {

JointReading reading_at(const sensor_msgs::JointState& message, std::size_t place) {
  JointReading reading;
  if (message.position.size() == message.name.size()) reading.position = message.position[place];
  if (message.velocity.size() == message.name.size()) reading.velocity = message.velocity[place];
  return reading;
}

}  // namespace

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string word; in >> word;) all.push_back(word);
  return all;
}

JointsRead read_joints(const sensor_msgs::JointState& message, const WheelJoints& joints) {
  JointsRead read;
  const auto take = [&](const std::vector<std::string>& names, std::vector<JointReading>& readings) {
    for (const std::string& name : names) {
      const auto found = std::find(message.name.begin(), message.name.end(), name);
      JointReading reading;
      if (found != message.name.end()) {
        read.names_any = true;
        reading = reading_at(message, static_cast<std::size_t>(found - message.name.begin()));
      }
      if (!reading.told()) read.missing.push_back(name);
      readings.push_back(reading);
    }
  };
  take(joints.left, read.readings.left);
  take(joints.right, read.readings.right);
  take(joints.steering, read.readings.steering);
  return read;
}

}  // namespace multipath_localization
