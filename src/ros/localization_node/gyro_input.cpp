#include "ros/localization_node/gyro_input.hpp"

#include <ros/console.h>

#include <cmath>
#include <utility>

namespace multipath_localization {

namespace {

constexpr std::uint32_t kQueue = 5000;  // seconds of it at 1 kHz
constexpr double kLongSilence = 2.0;    // [s]
constexpr char kTopic[] = "imu/data";

std::string sentence(const GyroTurn& gyro) {
  std::string text = to_string(gyro.standing());
  if (gyro.standing() == GyroStanding::kUsed) {
    text += ", " + std::to_string(std::lround(gyro.frequency())) + " Hz";
  }
  return text;
}

}  // namespace

GyroInput::GyroInput(ros::NodeHandle node, RotationFinder rotation_in_base, Take take)
    : reader_(std::move(rotation_in_base)),
      take_(std::move(take)),
      monitor_("gyro",
               {node.subscribe(kTopic, kQueue, &GyroInput::on_imu, this, ros::TransportHints().tcpNoDelay())},
               true) {}

void GyroInput::on_imu(const sensor_msgs::Imu::ConstPtr& message) {
  monitor_.arrived();
  const CheckedYawRate checked = reader_.read(*message);
  monitor_.count(checked.reason);
  if (checked.reason == Reason::kAccepted) take_(checked.yaw_rate);
  if (reader_.frame_is_news()) {
    ROS_WARN("%s: no transform to %s: it is taken to be level, with z upwards", kTopic,
             message->header.frame_id.c_str());
  }
  if (const std::string why = monitor_.complaint(); !why.empty()) ROS_WARN("%s", why.c_str());
}

void GyroInput::tell(const GyroTurn& gyro) {
  const GyroStanding now = gyro.standing();
  if (now == told_) return;
  told_ = now;
  if (now == GyroStanding::kUsed) {
    ROS_INFO("%s: %s", kTopic, sentence(gyro).c_str());
  } else {
    ROS_WARN("%s: %s", kTopic, sentence(gyro).c_str());
  }
}

InputMonitor::Standing GyroInput::standing(const GyroTurn& gyro) const {
  const InputMonitor::Standing input = monitor_.standing();
  if (monitor_.tally().of(Reason::kUnused) == monitor_.tally().total()) {
    return {true, "has no gyro: its angular velocity is declared as unknown"};
  }
  if (!input.sound || monitor_.silent(kLongSilence)) return input;
  return {gyro.standing() == GyroStanding::kUsed, sentence(gyro)};
}

}  // namespace multipath_localization
