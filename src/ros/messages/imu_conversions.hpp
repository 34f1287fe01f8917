#pragma once

#include <sensor_msgs/Imu.h>

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// A yaw rate, or the reason why there is none.
struct CheckedYawRate {
  Reason reason = Reason::kAccepted;
  YawRate yaw_rate;  ///< counts only when accepted
};

/// Finds how a frame is turned against the base, nothing where tf does not know.
using RotationFinder = std::function<std::optional<Eigen::Quaterniond>(const std::string& frame)>;

/// Reads the yaw rate about the vertical from sensor_msgs/Imu.
///
/// The vertical in the frame of the message is where its orientation has it; without one, or where that is
/// over 30 degrees off gravity, as with one in NED, where gravity, the mean of `linear_acceleration` over
/// seconds, pulls; and without that, as in a driver that fills in neither, the z axis of the base by tf.
/// Gravity counts only where it is as large as it is on Earth.
///
/// | in the message                                            | what happens             |
/// |-----------------------------------------------------------|--------------------------|
/// | stamp zero                                                | refused: zero stamp      |
/// | angular_velocity_covariance[0] is -1: it has no gyro      | refused: unused          |
/// | angular velocity NaN or infinite                          | refused: not finite      |
/// | yaw rate above 20 rad/s                                   | refused: too fast        |
/// | orientation_covariance[0] is -1, or no unit quaternion    | its gravity, or the base |
/// | frame unknown to tf                                       | as if it was the base's  |
class ImuReader {
 public:
  /// `rotation_in_base` is asked at each message.
  explicit ImuReader(RotationFinder rotation_in_base) : rotation_in_base_(std::move(rotation_in_base)) {}

  CheckedYawRate read(const sensor_msgs::Imu& message);

  /// Whether the last message's frame was unknown, and no earlier one's.
  [[nodiscard]] bool frame_is_news() const { return news_; }
  [[nodiscard]] bool frame_known() const { return known_; }

 private:
  /// The vertical, upwards, in the frame of the message.
  Eigen::Vector3d up(const sensor_msgs::Imu& message);
  void take_gravity(const sensor_msgs::Imu& message);

  RotationFinder rotation_in_base_;
  Eigen::Vector3d gravity_ = Eigen::Vector3d::Zero();  ///< mean acceleration at rest, upwards [m/s^2]
  double gravity_time_ = 0.0;                          ///< that is in it [s]
  double last_stamp_ = 0.0;                            ///< [s]
  bool known_ = true;
  bool news_ = false;
  std::set<std::string> unknown_;
};

/// A message that tells a yaw rate alone, of a sensor mounted level.
sensor_msgs::Imu to_message(const YawRate& yaw_rate, const std_msgs::Header& header);

}  // namespace multipath_localization
