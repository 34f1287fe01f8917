#include "multipath_localization/guidance/command_limiter.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

namespace {

/// `value` moved towards `goal` by at most `step`.
double approach(double value, double goal, double step) {
  return std::abs(goal - value) <= step ? goal : value + std::copysign(step, goal - value);
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
  field("max_steering_rate", max_steering_rate, {1e-3, 1e6}, "rad/s",
        "front_steering: of the commanded steering angle");
  field("max_yaw_rate", max_yaw_rate, {1e-3, 1e3}, "rad/s", "differential: of commands");
  field("max_yaw_acceleration", max_yaw_acceleration, {1e-3, 1e6}, "rad/s^2", "differential: of commands");
}

CommandLimiter::CommandLimiter(const CommandLimits& limits, double wheelbase, const MotionCommand& last)
    : limits_(limits),
      wheelbase_(wheelbase),
      last_(last),
      yaw_rate_(multipath_localization::yaw_rate(last, wheelbase)) {}

MotionCommand CommandLimiter::limited(const MotionCommand& wanted, bool urgent, double duration,
                                      double spin) {
  const double dt = duration > 0.0 ? std::min(duration, kLongestStep) : 0.0;
  const bool stopping = wanted.speed == 0.0 && last_.speed != 0.0;
  const bool faster = std::abs(wanted.speed) > std::abs(last_.speed);
  const double brake =
      urgent ? std::max(limits_.emergency_deceleration, limits_.max_deceleration) : limits_.max_deceleration;
  const double angle = stopping ? last_.steering_angle : wanted.steering_angle;
  last_.speed = approach(last_.speed, wanted.speed, (faster ? limits_.max_acceleration : brake) * dt);
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
  yaw_rate_ = 0.0;
}

Pose2 CommandLimiter::carried_forward(const Pose2& pose, double age) const {
  if (!pose.finite() || !(age > 0.0) || !std::isfinite(age)) return pose;
  return pose * displacement({0.0, age, last_.speed, yaw_rate_});
}

}  // namespace multipath_localization
