#include "ros/messages/imu_conversions.hpp"

#include <algorithm>
#include <cmath>

#include "ros/messages/conversions.hpp"
#include "ros/messages/tilt_conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kFastest = 20.0;        // no robot spins so [rad/s]
constexpr double kGravity = 9.81;        // [m/s^2]
constexpr double kGravityOff = 1.5;      // that a mean may be off, by an accelerometer that is [m/s^2]
constexpr double kGravityTime = 5.0;     // over which pulling away and braking average out [s]
constexpr double kGravityEnough = 1.0;   // of it, before which the base's axis is as good [s]
constexpr double kLongestStep = 0.5;     // a gap is no time of acceleration [s]
constexpr double kAlike = 0.87;          // cosine of 30 degrees: more is no error of an orientation
constexpr double kNoiseVariance = 4e-6;  // that is declared: (0.002 rad/s)^2
constexpr std::size_t kMostFrames = 10;  // that are remembered as unknown

}  // namespace

CheckedYawRate ImuReader::read(const sensor_msgs::Imu& message) {
  CheckedYawRate checked;
  const auto refuse = [&](Reason reason) {
    checked.reason = reason;
    return checked;
  };
  if (message.header.stamp.isZero()) return refuse(Reason::kZeroStamp);
  if (message.header.stamp.toSec() > kLatestStamp) return refuse(Reason::kFutureStamp);
  if (!is_short(message.header.frame_id)) return refuse(Reason::kInvalidFrame);
  if (message.angular_velocity_covariance[0] == -1.0) return refuse(Reason::kUnused);
  const Eigen::Vector3d rate = vector_of(message.angular_velocity);
  if (!rate.allFinite()) return refuse(Reason::kNotFinite);
  checked.yaw_rate = {message.header.stamp.toSec(), rate.dot(up(message))};
  return std::abs(checked.yaw_rate.rate) > kFastest ? refuse(Reason::kTooFast) : checked;
}

Eigen::Vector3d ImuReader::up(const sensor_msgs::Imu& message) {
  const std::optional<Eigen::Quaterniond> in_base = rotation_in_base_(message.header.frame_id);
  known_ = in_base.has_value();
  news_ = !known_ && unknown_.size() < kMostFrames && unknown_.insert(message.header.frame_id).second;
  take_gravity(message);
  const bool falls = gravity_time_ >= kGravityEnough && std::abs(gravity_.norm() - kGravity) < kGravityOff;
  if (const auto orientation = orientation_of(message)) {
    const Eigen::Vector3d up = orientation->conjugate() * Eigen::Vector3d::UnitZ();
    if (!falls || up.dot(gravity_.normalized()) > kAlike) return up;
  }
  if (falls) return gravity_.normalized();
  return in_base.value_or(Eigen::Quaterniond::Identity()).conjugate() * Eigen::Vector3d::UnitZ();
}

void ImuReader::take_gravity(const sensor_msgs::Imu& message) {
  const Eigen::Vector3d acceleration = vector_of(message.linear_acceleration);
  const double stamp = message.header.stamp.toSec();
  const double step = std::clamp(stamp - last_stamp_, 0.0, kLongestStep);
  last_stamp_ = stamp;
  if (message.linear_acceleration_covariance[0] == -1.0 || !acceleration.allFinite()) return;
  gravity_time_ = std::min(gravity_time_ + step, kGravityTime);
  if (gravity_time_ > 0.0) gravity_ += std::min(1.0, step / gravity_time_) * (acceleration - gravity_);
}

sensor_msgs::Imu to_message(const YawRate& yaw_rate, const std_msgs::Header& header) {
  sensor_msgs::Imu message;
  message.header = header;
  message.orientation.w = 1.0;
  message.orientation_covariance[0] = -1.0;
  message.linear_acceleration_covariance[0] = -1.0;
  message.angular_velocity.z = yaw_rate.rate;
  for (const std::size_t axis : {0U, 4U, 8U}) message.angular_velocity_covariance[axis] = kNoiseVariance;
  return message;
}

}  // namespace multipath_localization
