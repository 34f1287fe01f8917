#pragma once

#include <Eigen/Core>

#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

/// What a Kalman filter of fixes and odometry estimates: the base in map and the odometer's slow errors.
/// Vectors hold x, y [m], yaw [rad], speed scale [1], gyro bias [rad/s]; their yaw need not be wrapped.
namespace multipath_localization::odometry_state {

enum Index : int { kX, kY, kYaw, kScale, kGyroBias, kSize };

using Vector = Eigen::Matrix<double, kSize, 1>;
using Matrix = Eigen::Matrix<double, kSize, kSize>;

/// The base in map, its yaw wrapped.
Pose2 pose(const Vector& state);

OdometerErrors errors(const Vector& state);

/// One increment as `kalman::predict` takes it.
struct Step {
  Vector mean;  ///< f(x, u), its yaw wrapped
  Matrix F;     ///< df/dx
  Matrix Q;     ///< noise of the motion and walk of the odometer's errors
};
Step step(const Vector& state, const OdometryIncrement& u, const OdometryNoise& noise);

/// H = dh/dx, 2 x 5, of the antenna's position in map.
Eigen::Matrix<double, 2, kSize> antenna_jacobian(const Vector& state, const Eigen::Vector2d& antenna_in_base);

/// The covariance before anything is known: 1 for the position, a heading anywhere on the circle, the
/// odometer's errors as `noise` has them.
Matrix unknown_covariance(const OdometryNoise& noise);

}  // namespace multipath_localization::odometry_state
