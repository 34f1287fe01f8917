#include "ros/messages/tilt_conversions.hpp"

#include <cmath>

#include "ros/messages/conversions.hpp"
#include "ros/messages/imu_conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kGravity = 9.81;       // [m/s^2]
constexpr double kTiltVariance = 1e-4;  // that is declared of a tilt [rad^2] and of gravity [m^2/s^4]

/// The vector in the base; nothing where its variance is unknown or it is not finite.
std::optional<Eigen::Vector3d> in_base(const Eigen::Quaterniond& imu_in_base,
                                       const geometry_msgs::Vector3& vector, double variance) {
  const Eigen::Vector3d read = vector_of(vector);
  if (variance == -1.0 || !read.allFinite()) return std::nullopt;
  return imu_in_base * read;
}

}  // namespace

geometry_msgs::Quaternion to_orientation(double yaw, const Tilt& tilt) {
  const Eigen::Quaterniond heading(std::cos(0.5 * yaw), 0.0, 0.0, std::sin(0.5 * yaw));
  const Eigen::Quaterniond turn = heading * Eigen::Quaterniond(rotation(tilt));
  geometry_msgs::Quaternion message;
  message.x = turn.x();
  message.y = turn.y();
  message.z = turn.z();
  message.w = turn.w();
  return message;
}

std::optional<Eigen::Quaterniond> orientation_of(const sensor_msgs::Imu& message) {
  const geometry_msgs::Quaternion& q = message.orientation;
  const Eigen::Quaterniond orientation(q.w, q.x, q.y, q.z);
  if (message.orientation_covariance[0] == -1.0) return std::nullopt;
  if (!(std::abs(orientation.norm() - 1.0) <= kQuaternionTolerance)) return std::nullopt;
  return orientation.normalized();
}

std::optional<InertialSample> to_inertial(const sensor_msgs::Imu& message,
                                          const Eigen::Quaterniond& imu_in_base) {
  if (message.header.stamp.isZero() || message.header.stamp.toSec() > kLatestStamp) return std::nullopt;
  InertialSample sample;
  sample.stamp = message.header.stamp.toSec();
  sample.acceleration =
      in_base(imu_in_base, message.linear_acceleration, message.linear_acceleration_covariance[0]);
  sample.rate = in_base(imu_in_base, message.angular_velocity, message.angular_velocity_covariance[0]);
  const bool filled_in = message.orientation.x != 0.0 || message.orientation.y != 0.0;
  if (const auto orientation = orientation_of(message); orientation && filled_in) {
    sample.up = imu_in_base * (orientation->conjugate() * Eigen::Vector3d::UnitZ());
  }
  if (!sample.up && !sample.acceleration) return std::nullopt;
  return sample;
}

sensor_msgs::Imu to_message(const YawRate& yaw_rate, const std_msgs::Header& header, const Tilt& tilt) {
  sensor_msgs::Imu message = to_message(yaw_rate, header);
  const Eigen::Vector3d up = up_in_base(tilt);
  message.angular_velocity.z = yaw_rate.rate * std::cos(tilt.pitch) / std::cos(tilt.roll);
  message.linear_acceleration = to_message(kGravity * up);
  message.orientation = to_orientation(0.0, tilt);
  for (const std::size_t axis : {0U, 4U, 8U}) {
    message.orientation_covariance[axis] = message.linear_acceleration_covariance[axis] = kTiltVariance;
  }
  return message;
}

}  // namespace multipath_localization
