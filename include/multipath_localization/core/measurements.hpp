#pragma once

#include <Eigen/Core>
#include <variant>

#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// Motion that wheel odometry saw over one interval, constant speed and yaw rate within it.
struct OdometryIncrement {
  double stamp = 0.0;     ///< end of the interval [s]
  double duration = 0.0;  ///< length of the interval [s], > 0
  double speed = 0.0;     ///< along x of the base, negative in reverse [m/s]
  double yaw_rate = 0.0;  ///< counter-clockwise [rad/s]
};

/// Motion of the base over the increment, in the base frame at its start: an arc in chord form, exact and
/// without the singularity of Eq. (3) of [NIS] at zero yaw rate.
Pose2 displacement(const OdometryIncrement& increment);

/// A position from a GNSS receiver, in the ENU map frame.
struct GnssFix {
  double stamp = 0.0;                                         ///< time of measurement [s]
  Eigen::Vector2d position = Eigen::Vector2d::Zero();         ///< antenna in map: east, north [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();   ///< as declared by the receiver [m^2]
  Eigen::Vector2d antenna_in_base = Eigen::Vector2d::Zero();  ///< lever arm [m]
};

/// What an estimator can be updated with.
using Measurement = std::variant<GnssFix>;

double stamp_of(const Measurement& measurement);

}  // namespace multipath_localization
