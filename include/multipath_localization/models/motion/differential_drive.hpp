#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// Speeds of two driven wheels on one axle, u of Eq. (2) of [KAM] [m/s].
struct WheelSpeeds {
  double left = 0.0;
  double right = 0.0;
};

/// Those of a base that moves at `speed` [m/s] and turns at `yaw_rate` [rad/s] on wheels `separation` [m]
/// apart.
WheelSpeeds wheel_speeds(double speed, double yaw_rate, double separation);

/// Speed of the middle of the axle [m/s].
double speed(const WheelSpeeds& wheels);

/// [rad/s]
double yaw_rate(const WheelSpeeds& wheels, double separation);

/// Derivative of (x, y, yaw) at the end of an increment to the speeds of the left and right wheel during it
/// [s, s, rad s/m].
///
/// Departs: B of Eq. (3) of [KAM], a straight step with the yaw as if it were commanded, becomes the arc of
/// a differential drive; its first two rows, at zero yaw rate, are B's.
Eigen::Matrix<double, 3, 2> wheel_jacobian(const Pose2& pose, const OdometryIncrement& u, double separation);

}  // namespace multipath_localization
