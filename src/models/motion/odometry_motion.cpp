#include "multipath_localization/models/motion/odometry_motion.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

double sinc_slope(double x) {
  return std::abs(x) < 1e-4 ? -x / 3.0 : (x * std::cos(x) - std::sin(x)) / (x * x);
}

}  // namespace

bool standing(const OdometryIncrement& u) { return ground_speed(u) < kStandstillSpeed && u.yaw_rate == 0.0; }

OdometryIncrement without_errors(const OdometryIncrement& u, const OdometerErrors& errors) {
  OdometryIncrement corrected = u;
  corrected.speed /= 1.0 + errors.speed_scale;
  corrected.lateral_speed /= 1.0 + errors.speed_scale;
  corrected.yaw_rate -= errors.gyro_bias;
  return corrected;
}

Pose2 moved(const Pose2& pose, const OdometryIncrement& u, const OdometerErrors& errors) {
  return pose * displacement(without_errors(u, errors));
}

MotionJacobians motion_jacobians(const Pose2& pose, const OdometryIncrement& u,
                                 const OdometerErrors& errors) {
  const OdometryIncrement true_u = without_errors(u, errors);
  const double dt = u.duration;
  const double half_turn = 0.5 * true_u.yaw_rate * dt;
  const double a = pose.yaw + half_turn;
  const Eigen::Vector2d along(std::cos(a), std::sin(a));
  const Eigen::Vector2d across(-along.y(), along.x());
  const auto moved_by = [&](double speed, double lateral_speed) -> Eigen::Vector2d {
    return rotation(pose.yaw) *
           displacement({true_u.stamp, dt, speed, true_u.yaw_rate, lateral_speed}).position();
  };
  const Eigen::Vector2d forwards = moved_by(true_u.speed, 0.0);
  const Eigen::Vector2d sideways = moved_by(0.0, true_u.lateral_speed);
  const Eigen::Vector2d turned_way = forwards.dot(along) * across - sideways.dot(across) * along;
  const double way_per_rate = dt * sinc_slope(half_turn) * 0.5 * dt;

  MotionJacobians result;
  result.pose.setIdentity();
  result.pose.block<2, 1>(0, 2) = turned_way;
  result.errors.setZero();
  result.errors.block<2, 1>(0, 0) = -(forwards + sideways) / (1.0 + errors.speed_scale);
  result.errors.block<2, 1>(0, 1) =
      -(way_per_rate * (true_u.speed * along + true_u.lateral_speed * across) + 0.5 * dt * turned_way);
  result.errors(2, 1) = -dt;
  return result;
}

}  // namespace multipath_localization
