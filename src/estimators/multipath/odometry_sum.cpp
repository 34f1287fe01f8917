#include "estimators/multipath/odometry_sum.hpp"

#include <cmath>

#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kAcrossToAlong = 0.5;      ///< wheels slip sideways less than they slip along [1]
constexpr double kTurnNoiseOfTurn = 0.004;  ///< wheels scrub in turns; a gyro's scale [rad/sqrt(rad)]
constexpr double kGyroNoise = 0.001;        ///< of a cheap one on a robot that shakes [rad/sqrt(s)]

/// Standard deviation of a value that is anywhere within an interval of length 1: 1 / sqrt(12).
constexpr double kUniform = 0.2887;
/// Longer intervals are gaps of the odometry: the slowest odometry in use comes at 1 Hz, and loses some [s].
constexpr double kGap = 2.5;
/// What a robot changes its speed by, within a gap, beyond what it had before it [m/s].
constexpr double kUnseenSpeed = 1.0;
/// Turns that nobody measures: 0.15 rad/s as cars and robots do, for three seconds each [rad/sqrt(s)].
constexpr double kUntoldTurn = 0.4;

Eigen::Vector2d perpendicular(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

void OdometrySum::restart(const OdometryErrors& errors) {
  const Before before = before_;
  *this = OdometrySum(noise_);
  errors_ = errors;
  before_ = before;
}

void OdometrySum::rest(const OdometryIncrement& u) {
  before_.velocity.setZero();
  if (!std::isfinite(u.rate_at_rest)) return;
  rest_time_ += u.duration;
  rest_turn_ += u.duration * u.rate_at_rest;
}

OdometryIncrement OdometrySum::without_turn_errors(OdometryIncrement u) const {
  if (u.turn_source == TurnSource::kGyro) {
    u.yaw_rate -= errors_.imu_bias;
  } else {
    u.yaw_rate = u.yaw_rate * (1.0 - errors_.turn_scale) - errors_.gyro_bias - errors_.curvature * u.speed;
  }
  return u;
}

OdometryIncrement OdometrySum::corrected(OdometryIncrement u) const {
  u = without_turn_errors(u);
  u.speed *= 1.0 - errors_.scale;
  u.lateral_speed *= 1.0 - errors_.scale;
  return u;
}

void OdometrySum::add(const OdometryIncrement& u) {
  const double dt = u.duration;
  const double moved = before_.moving.add(u);
  duration_ += dt;
  if (dt > kGap) {
    missing_time_ += dt;
    const double reach = (ground_speed(u) + kUnseenSpeed) * dt;
    sampling_noise_.topLeftCorner<2, 2>() += square(0.5 * reach) * Eigen::Matrix2d::Identity();
  } else if (standing(u)) {
    rest(u);
    return;
  }
  const bool by_gyro = u.turn_source == TurnSource::kGyro;
  const OdometryIncrement corrected = this->corrected(u);
  const Pose2 step = multipath_localization::displacement(corrected);
  const Eigen::Vector2d way = rotation(turn_) * step.position();
  before_.turned = before_.turned || u.yaw_rate != 0.0;

  add_noise(u, moved, way, corrected.yaw_rate * dt);
  // The heading halfway through the step, by each of the errors that turn it.
  const Eigen::RowVector4d turn_by_errors =
      by_gyro ? Eigen::RowVector4d(0.0, 0.0, 0.0, -dt)
              : Eigen::RowVector4d(-dt, -u.yaw_rate * dt, -u.speed * dt, 0.0);
  const Eigen::RowVector4d heading = by_errors_.bottomRightCorner<1, 4>() + 0.5 * turn_by_errors;
  by_errors_.topLeftCorner<2, 1>() -= way / (1.0 - errors_.scale);
  by_errors_.topRightCorner<2, 4>() += perpendicular(way) * heading;
  by_errors_.bottomRightCorner<1, 4>() += turn_by_errors;

  displacement_ += way;
  turn_ += corrected.yaw_rate * dt;
  moving_time_ += moved;
  if (by_gyro) gyro_time_ += moved;
  length_ += way.norm();
  before_.velocity << u.speed, u.lateral_speed;
}

void OdometrySum::add_noise(const OdometryIncrement& u, double moved, const Eigen::Vector2d& way,
                            double turn) {
  const double length = way.norm();
  const double dt = u.duration;
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F.topRightCorner<2, 1>() = perpendicular(way);
  for (Eigen::Matrix3d* noise : {&way_noise_, &turn_noise_, &gyro_noise_, &sampling_noise_, &untold_turns_}) {
    *noise = F * *noise * F.transpose();
  }
  const double across = square(kAcrossToAlong * noise_.distance) * length;
  way_noise_.topLeftCorner<2, 2>() += across * Eigen::Matrix2d::Identity();
  if (length > 0.0) {
    const Eigen::Vector2d along = way / length;
    way_noise_.topLeftCorner<2, 2>() +=
        (square(noise_.distance) * length - across) * along * along.transpose();
  }
  const double of_turn = square(kTurnNoiseOfTurn) * std::abs(turn);
  if (u.turn_source == TurnSource::kGyro) {
    gyro_noise_(2, 2) += square(kGyroNoise) * moved + of_turn;
  } else {
    turn_noise_(2, 2) += square(noise_.yaw) * moved + of_turn;
  }
  if (!before_.turned) untold_turns_(2, 2) += square(kUntoldTurn) * moved;
  // What happened between two samples is not known: speed and turn changed anywhere within the interval.
  const double change = (Eigen::Vector2d(u.speed, u.lateral_speed) - before_.velocity).norm() * dt;
  const double bend = length * std::abs(turn);
  const double direction = turn_ + 0.5 * turn;
  const Eigen::Vector2d ahead(std::cos(direction), std::sin(direction));
  sampling_noise_.topLeftCorner<2, 2>() +=
      square(kUniform * change) * ahead * ahead.transpose() +
      square(kUniform * bend) * perpendicular(ahead) * perpendicular(ahead).transpose();
}

}  // namespace multipath_localization::multipath
