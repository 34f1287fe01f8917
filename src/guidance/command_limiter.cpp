#include "multipath_localization/guidance/command_limiter.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

namespace {

constexpr double kSameSpeed = 1e-9;  // [m/s]
// Of the acceleration, when a way of some tenths of a metre has to be braked for.
constexpr double kStillSpeedingUp = 0.25;

/// `value` moved towards `goal` by at most `step`.
double approach(double value, double goal, double step) {
  return std::abs(goal - value) <= step ? goal : value + std::copysign(step, goal - value);
}

/// The acceleration over the next `dt` [s] that changes by `jerk` at most, from `now` on, and brings `gap`
/// [m/s] about: the most from which it is taken back to nothing, by as much a step, just when the gap closes.
double closing(double gap, double now, double jerk, double dt) {
  const double step = jerk * dt;
  const double size = std::abs(gap) / (step * dt);  // 1 + 2 + ... + n, and a part of n + 1
  const double n = std::floor(0.5 * (std::sqrt(1.0 + 8.0 * size) - 1.0));
  const double most = step * (size / (n + 1.0) + 0.5 * n);
  return std::clamp(std::copysign(most, gap), now - step, now + step);
}

}  // namespace

void CommandLimits::fields(ParameterVisitor& field) {
  field("base", base, {"front_steering", "differential"},
        "front_steering: turns by its front wheels; differential: by the speeds of its wheels or tracks, on "
        "the "
        "spot too, skid steer likewise");
  field("max_acceleration", max_acceleration, {1e-3, 1e6}, "m/s^2", "of commands, speeding up");
  field("max_deceleration", max_deceleration, {1e-3, 1e6}, "m/s^2",
        "of commands, slowing down: before bends, the goal, and at an order to stand");
  field("emergency_deceleration", emergency_deceleration, {1e-3, 1e6}, "m/s^2",
        "of commands, where the pose must not be driven by");
  field("max_jerk", max_jerk, {1e-2, 1e6}, "m/s^3",
        "of commands, how fast their acceleration changes; 1 is gentle, 5 firm; not where the pose must not "
        "be driven by");
  field("max_steering_rate", max_steering_rate, {1e-3, 1e6}, "rad/s",
        "front_steering: of the commanded steering angle");
  field("max_yaw_rate", max_yaw_rate, {1e-3, 1e3}, "rad/s", "differential: of commands");
  field("max_yaw_acceleration", max_yaw_acceleration, {1e-3, 1e6}, "rad/s^2", "differential: of commands");
}

double CommandLimits::braking_delay(double deceleration) const {
  const double swing = kStillSpeedingUp * std::min(max_acceleration, max_deceleration) + deceleration;
  return swing * swing / (2.0 * max_jerk * deceleration);
}

CommandLimiter::CommandLimiter(const CommandLimits& limits, double wheelbase, const MotionCommand& last)
    : limits_(limits),
      wheelbase_(wheelbase),
      last_(last),
      yaw_rate_(multipath_localization::yaw_rate(last, wheelbase)) {}

double CommandLimiter::next_speed_urgently(double wanted, double dt) {
  const bool faster = std::abs(wanted) > std::abs(last_.speed);
  const double brake = std::max(limits_.emergency_deceleration, limits_.max_deceleration);
  const double next = approach(last_.speed, wanted, (faster ? limits_.max_acceleration : brake) * dt);
  acceleration_ = next == wanted ? 0.0 : (next - last_.speed) / dt;
  return next;
}

double CommandLimiter::next_speed(double wanted, double dt) {
  const double way = last_.speed != 0.0 ? std::copysign(1.0, last_.speed) : std::copysign(1.0, wanted);
  const double goal = std::max(0.0, way * wanted);  // the other way by rest alone
  const double speed = way * last_.speed;
  const double slowest = speed > 0.0 ? -limits_.max_deceleration : 0.0;
  const double a = std::clamp(closing(goal - speed, way * acceleration_, limits_.max_jerk, dt), slowest,
                              limits_.max_acceleration);
  double next = speed + a * dt;
  if (std::abs(next - goal) < kSameSpeed) next = goal;
  next = std::max(next, 0.0);
  acceleration_ = next > 0.0 ? way * a : 0.0;
  return next > 0.0 ? way * next : 0.0;
}

MotionCommand CommandLimiter::limited(const MotionCommand& wanted, bool urgent, double duration,
                                      double spin) {
  const double dt = duration > 0.0 ? std::min(duration, kLongestStep) : 0.0;
  const bool stopping = wanted.speed == 0.0 && last_.speed != 0.0;
  const double angle = stopping ? last_.steering_angle : wanted.steering_angle;
  if (dt > 0.0) last_.speed = urgent ? next_speed_urgently(wanted.speed, dt) : next_speed(wanted.speed, dt);
  if (limits_.differential()) {
    const double wanted_rate =
        last_.speed == 0.0 ? spin : multipath_localization::yaw_rate({last_.speed, angle}, wheelbase_);
    const double goal = std::clamp(wanted_rate, -limits_.max_yaw_rate, limits_.max_yaw_rate);
    yaw_rate_ = approach(yaw_rate_, goal, limits_.max_yaw_acceleration * dt);
    last_ = motion_command(last_.speed, yaw_rate_, wheelbase_);
  } else {
    last_.steering_angle = approach(last_.steering_angle, angle, limits_.max_steering_rate * dt);
    yaw_rate_ = multipath_localization::yaw_rate(last_, wheelbase_);
  }
  return last_;
}

void CommandLimiter::halt() {
  last_ = {};
  acceleration_ = 0.0;
  yaw_rate_ = 0.0;
}

Pose2 CommandLimiter::carried_forward(const Pose2& pose, double age) const {
  if (!pose.finite() || !(age > 0.0) || !std::isfinite(age)) return pose;
  return pose * displacement({0.0, age, last_.speed, yaw_rate_});
}

}  // namespace multipath_localization
