#include "estimators/multipath/odometry_jump.hpp"

#include <cmath>
#include <utility>

namespace multipath_localization {

namespace {

constexpr double kWindow = 0.1;     ///< means are taken over this long [s]
constexpr double kNoiseGate = 5.0;  ///< sigma of the declared noise
constexpr double kRounding = 1e-6;

}  // namespace

void OdometryJumpParameters::fields(ParameterVisitor& field) {
  field("largest_acceleration", largest_acceleration, {0.1, 1e6}, "m/s^2",
        "odometry that says more of it is suspected of a fault");
  field("largest_yaw_acceleration", largest_yaw_acceleration, {0.1, 1e6}, "rad/s^2", "the same of turning");
  field("fault_probability", fault_probability, {0.0, 0.9}, "1",
        "probability of a fault of the wheels where the odometry is suspected");
}

void OdometryJump::add(const OdometryIncrement& u) {
  current_.duration += u.duration;
  current_.way += u.duration * Eigen::Vector2d(u.speed, u.lateral_speed);
  current_.turn += u.yaw_rate * u.duration;
  if (current_.duration < kWindow - kRounding) return;
  if (last_but_one_) {
    const Jump now = between(*last_but_one_, *last_, current_);
    jump_ = {jump_.speed || now.speed, jump_.turn || now.turn};
  }
  last_but_one_ = last_;
  last_ = current_;
  current_ = {};
}

OdometryJump::Jump OdometryJump::between(const Window& before, const Window& middle,
                                         const Window& after) const {
  const double time = middle.duration + 0.5 * (before.duration + after.duration);
  const Eigen::Vector2d change = after.way / after.duration - before.way / before.duration;
  const double speed = std::hypot(change.x(), change.y());
  const double yaw_rate = after.turn / after.duration - before.turn / before.duration;
  const double way = std::hypot(before.way.x(), before.way.y()) + std::hypot(after.way.x(), after.way.y());
  const double speed_noise = noise_.distance * std::sqrt(way) / after.duration;
  const double yaw_rate_noise = noise_.yaw * std::sqrt(before.duration + after.duration) / after.duration;
  const double most_speed = parameters_.largest_acceleration * time + kNoiseGate * speed_noise;
  const double most_turn = parameters_.largest_yaw_acceleration * time + kNoiseGate * yaw_rate_noise;
  return {speed > most_speed, std::abs(yaw_rate) > most_turn};
}

OdometryJump::Jump OdometryJump::take() { return std::exchange(jump_, Jump{}); }

}  // namespace multipath_localization
