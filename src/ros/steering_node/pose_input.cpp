#include "ros/steering_node/pose_input.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Trust to_trust(const LocalizationState& message) {
  return message.state <= LocalizationState::LOST ? static_cast<Trust>(message.state) : Trust::kLost;
}

}  // namespace

void PoseInput::take(const nav_msgs::Odometry& message, const ros::SteadyTime& arrived) {
  pose_ = to_pose2(message.pose.pose).value_or(Pose2{kNaN, kNaN, kNaN});
  sigma_ = std::sqrt(0.5 * (message.pose.covariance[0] + message.pose.covariance[7]));
  arrival_ = {message.header.stamp, arrived};
}

bool PoseInput::take(const LocalizationState& message) {
  const Trust before = std::exchange(trust_, to_trust(message));
  return trust_ != before && !known();
}

}  // namespace multipath_localization
