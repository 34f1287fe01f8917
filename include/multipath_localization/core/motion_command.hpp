#pragma once

#include <cmath>

namespace multipath_localization {

/// Reference input of a front-wheel-steering robot, Eq. (2) of [NIS].
struct MotionCommand {
  double speed = 0.0;           ///< of the rear axle's centre along x of the base, negative in reverse [m/s]
  double steering_angle = 0.0;  ///< of the front wheel, counter-clockwise, within (-pi/2, pi/2) [rad]

  [[nodiscard]] bool finite() const { return std::isfinite(speed) && std::isfinite(steering_angle); }
};

/// Yaw rate of the base [rad/s] for a wheelbase [m], Eq. (4) of [NIS].
inline double yaw_rate(const MotionCommand& command, double wheelbase) {
  return command.speed / wheelbase * std::tan(command.steering_angle);
}

/// The inverse of Eq. (4) of [NIS]: the command that drives at `speed` [m/s] and turns at `yaw_rate` [rad/s].
/// At rest a steered robot cannot turn: the angle is then zero.
inline MotionCommand motion_command(double speed, double yaw_rate, double wheelbase) {
  return {speed, speed == 0.0 ? 0.0 : std::atan(wheelbase * yaw_rate / speed)};
}

}  // namespace multipath_localization
