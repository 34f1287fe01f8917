#include "ros/messages/heading_conversions.hpp"

#include <cmath>
#include <limits>

#include "ros/messages/conversions.hpp"
#include "ros/messages/tilt_conversions.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kImuYaw = 8;           ///< in a row-major 3x3
constexpr std::size_t kRoll = 21, kSix = 6;  ///< in a row-major 6x6: the block of roll, pitch and yaw

/// Of x of the rotated frame, about the vertical [rad].
double yaw_of(const Eigen::Quaterniond& rotation) {
  const Eigen::Vector3d ahead = rotation * Eigen::Vector3d::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

}  // namespace

void HeadingParameters::fields(ParameterVisitor& field) {
  field("default_sigma", default_sigma, {1e-3, 3.0}, "rad", "of a heading that declares no variance");
}

Reason check(const sensor_msgs::Imu& message) {
  if (message.header.stamp.isZero()) return Reason::kZeroStamp;
  if (!is_short(message.header.frame_id)) return Reason::kInvalidFrame;
  if (message.orientation_covariance[0] == -1.0) return Reason::kUnused;
  if (!orientation_of(message)) return Reason::kInvalidOrientation;
  const double variance = message.orientation_covariance[kImuYaw];
  return std::isfinite(variance) && variance >= 0.0 ? Reason::kAccepted : Reason::kInvalidCovariance;
}

CheckedHeading to_heading(const sensor_msgs::Imu& message, const HeadingParameters& parameters,
                          const Eigen::Quaterniond& in_base) {
  CheckedHeading checked;
  checked.reason = check(message);
  if (checked.reason != Reason::kAccepted) return checked;
  const double variance = message.orientation_covariance[kImuYaw];
  checked.heading = {message.header.stamp.toSec(), yaw_of(*orientation_of(message) * in_base.conjugate()),
                     variance > 0.0 ? variance : square(parameters.default_sigma)};
  return checked;
}

double declared_heading_sigma(const sensor_msgs::Imu& message) {
  const double variance = message.orientation_covariance[kImuYaw];
  return variance > 0.0 ? std::sqrt(variance) : std::numeric_limits<double>::quiet_NaN();
}

sensor_msgs::Imu orientation_alone(const geometry_msgs::PoseWithCovarianceStamped& message) {
  sensor_msgs::Imu result;
  result.header = message.header;
  result.header.frame_id.clear();
  result.orientation = message.pose.pose.orientation;
  for (std::size_t i = 0; i < 9; ++i) {
    result.orientation_covariance[i] = message.pose.covariance[kRoll + kSix * (i / 3) + i % 3];
  }
  return result;
}

sensor_msgs::Imu to_message(const Heading& heading, const std_msgs::Header& header) {
  sensor_msgs::Imu message;
  message.header = header;
  message.orientation = to_message(Pose2{0.0, 0.0, heading.yaw}).orientation;
  for (const std::size_t axis : {0U, 4U, 8U}) message.orientation_covariance[axis] = heading.variance;
  message.angular_velocity_covariance[0] = message.linear_acceleration_covariance[0] = -1.0;
  return message;
}

}  // namespace multipath_localization
