#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// A base that moves no faster, in whatever direction, stands [m/s].
inline constexpr double kStandstillSpeed = 0.01;

/// True when the base stands and there is no yaw rate at all: then nothing moves, turns or diffuses. What a
/// gyro says of a parked robot is for Standstill to judge.
bool standing(const OdometryIncrement& u);

/// The slowly varying errors of an odometer: true speed, forwards and sideways, = measured /
/// (1 + speed_scale), true yaw rate = measured - gyro_bias.
struct OdometerErrors {
  double speed_scale = 0.0;  ///< [1]
  double gyro_bias = 0.0;    ///< [rad/s]
};

/// The increment without those errors.
OdometryIncrement without_errors(const OdometryIncrement& u, const OdometerErrors& errors);

/// Pose at the end of an increment, the odometer's errors taken out.
Pose2 moved(const Pose2& pose, const OdometryIncrement& u, const OdometerErrors& errors);

/// Derivatives of `moved`.
struct MotionJacobians {
  Eigen::Matrix3d pose;                ///< of (x, y, yaw) to (x, y, yaw)
  Eigen::Matrix<double, 3, 2> errors;  ///< of (x, y, yaw) to (speed_scale, gyro_bias)
};
MotionJacobians motion_jacobians(const Pose2& pose, const OdometryIncrement& u, const OdometerErrors& errors);

}  // namespace multipath_localization
