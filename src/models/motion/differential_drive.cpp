#include "multipath_localization/models/motion/differential_drive.hpp"

#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization {

WheelSpeeds wheel_speeds(double speed, double yaw_rate, double separation) {
  const double half_difference = 0.5 * separation * yaw_rate;
  return {speed - half_difference, speed + half_difference};
}

double speed(const WheelSpeeds& wheels) { return 0.5 * (wheels.left + wheels.right); }

double yaw_rate(const WheelSpeeds& wheels, double separation) {
  return (wheels.right - wheels.left) / separation;
}

Eigen::Matrix<double, 3, 2> wheel_jacobian(const Pose2& pose, const OdometryIncrement& u, double separation) {
  OdometryIncrement at_unit_speed = u;
  at_unit_speed.speed = 1.0;
  at_unit_speed.lateral_speed = 0.0;
  Eigen::Vector3d by_speed = Eigen::Vector3d::Zero();
  by_speed.head<2>() = rotation(pose.yaw) * displacement(at_unit_speed).position();
  const Eigen::Vector3d by_yaw_rate = -motion_jacobians(pose, u, {}).errors.col(1);  // of a gyro's bias
  Eigen::Matrix<double, 3, 2> G;
  G << 0.5 * by_speed - by_yaw_rate / separation, 0.5 * by_speed + by_yaw_rate / separation;
  return G;
}

}  // namespace multipath_localization
