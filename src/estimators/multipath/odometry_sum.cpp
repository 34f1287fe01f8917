#include "estimators/multipath/odometry_sum.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization::multipath {

namespace {

/// Longer intervals are gaps of the odometry: the slowest odometry in use comes at 1 Hz, and loses some [s].
constexpr double kGap = 2.5;
/// A mean yaw rate below this may be noise on a straight way, of which fixes would say that turns are none:
/// it tells nothing of their scale [rad/s],
constexpr double kNoTurn = 0.02;
constexpr double kTurnMemory = 0.5;  ///< over so long a mean [s]
/// What a robot changes its speed by, within a gap, beyond what it had before it [m/s].
constexpr double kUnseenSpeed = 1.0;

Eigen::Vector2d perpendicular(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

OdometryIncrement scaled(OdometryIncrement u, double factor) {
  u.speed *= factor;
  u.lateral_speed *= factor;
  return u;
}

}  // namespace

void OdometrySum::restart(const OdometryErrors& errors) {
  const Before before = before_;
  *this = OdometrySum(supposed_);
  errors_ = errors;
  before_ = before;
}

void OdometrySum::rest(const OdometryIncrement& u) {
  before_.velocity.setZero();
  if (!std::isfinite(u.rate_at_rest)) return;
  gyro_at_rest_.time += u.duration;
  gyro_at_rest_.turn += u.duration * u.rate_at_rest;
}

double OdometrySum::Before::rate_of_turn(const OdometryIncrement& u) const {
  return std::abs(mean_yaw_rate) > kNoTurn ? u.yaw_rate : 0.0;
}

OdometryIncrement OdometrySum::without_turn_errors(OdometryIncrement u) const {
  if (u.turn_source == TurnSource::kGyro) {
    u.yaw_rate -= errors_.imu_bias;
  } else {
    u.yaw_rate -=
        errors_.turn_scale * before_.rate_of_turn(u) + errors_.gyro_bias + errors_.curvature * u.speed;
  }
  return u;
}

void OdometrySum::add(const OdometryIncrement& u) {
  const double dt = u.duration;
  const double moved = before_.moving.add(u);
  before_.mean_yaw_rate += std::min(1.0, dt / kTurnMemory) * (u.yaw_rate - before_.mean_yaw_rate);
  duration_ += dt;
  if (dt > kGap) {
    missing_time_ += dt;
    noise_.add_gap((ground_speed(u) + kUnseenSpeed) * dt);
  } else if (standing(u)) {
    rest(u);
    return;
  }
  const bool by_gyro = u.turn_source == TurnSource::kGyro;
  const OdometryIncrement corrected = scaled(without_turn_errors(u), 1.0 - errors_.scale);
  const Pose2 step = multipath_localization::displacement(corrected);
  const Eigen::Vector2d way = rotation(turn_) * step.position();
  before_.turned = before_.turned || u.yaw_rate != 0.0;

  const double turn = corrected.yaw_rate * dt;
  const double change = (Eigen::Vector2d(u.speed, u.lateral_speed) - before_.velocity).norm() * dt;
  noise_.add({way, turn_ + 0.5 * turn, turn, moved, change, u.turn_source, before_.turned});
  // The heading halfway through the step, by each of the errors that turn it.
  const Eigen::RowVector4d turn_by_errors =
      by_gyro ? Eigen::RowVector4d(0.0, 0.0, 0.0, -dt)
              : Eigen::RowVector4d(-dt, -before_.rate_of_turn(u) * dt, -u.speed * dt, 0.0);
  const Eigen::RowVector4d heading = by_errors_.bottomRightCorner<1, 4>() + 0.5 * turn_by_errors;
  by_errors_.topLeftCorner<2, 1>() -= way / (1.0 - errors_.scale);
  by_errors_.topRightCorner<2, 4>() += perpendicular(way) * heading;
  by_errors_.bottomRightCorner<1, 4>() += turn_by_errors;

  displacement_ += way;
  turn_ += turn;
  moving_time_ += moved;
  if (by_gyro) gyro_time_ += moved;
  length_ += way.norm();
  before_.velocity << u.speed, u.lateral_speed;
}

}  // namespace multipath_localization::multipath
