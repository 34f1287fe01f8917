#include "ros/localization_node/tilt_input.hpp"

#include <ros/console.h>

#include <string>
#include <utility>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr std::uint32_t kQueue = 5000;  // seconds of it at 1 kHz
constexpr char kTopic[] = "imu/data";

}  // namespace

TiltInput::TiltInput(ros::NodeHandle node, bool wanted, RotationFinder rotation_in_base)
    : rotation_in_base_(std::move(rotation_in_base)) {
  if (!wanted) return;
  subscriber_ = node.subscribe(kTopic, kQueue, &TiltInput::on_imu, this, ros::TransportHints().tcpNoDelay());
}

void TiltInput::drive(const OdometryIncrement& motion) {
  now_ = motion.stamp;
  record_.drive(motion);
}

void TiltInput::on_imu(const sensor_msgs::Imu::ConstPtr& message) {
  if (!is_short(message->header.frame_id)) return;
  const auto imu_in_base = rotation_in_base_(message->header.frame_id);
  mounted_ = imu_in_base.has_value();
  if (!mounted_) return;
  if (const auto sample = to_inertial(*message, *imu_in_base)) record_.add(*sample);
}

bool TiltInput::seen() const { return !mounted_ || record_.standing(now_) != TiltStanding::kAbsent; }

InputMonitor::Standing TiltInput::standing() const {
  if (!mounted_) return {true, "tf does not know how it is mounted: roll and pitch are not used"};
  const TiltStanding standing = record_.standing(now_);
  return {standing == TiltStanding::kUsed, to_string(standing)};
}

void TiltInput::tell() {
  const InputMonitor::Standing now = standing();
  if (!seen() || (told_ && now.sound == told_sound_)) return;
  told_ = true;
  told_sound_ = now.sound;
  if (now.sound) {
    ROS_INFO("%s: %s", kTopic, now.sentence.c_str());
  } else {
    ROS_WARN("%s: %s", kTopic, now.sentence.c_str());
  }
}

}  // namespace multipath_localization
