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
  field("max_acceleration", max_acceleration, {1e-3, 1e6}, "m/s^2", "of commands, speeding up");
  field("max_deceleration", max_deceleration, {1e-3, 1e6}, "m/s^2",
        "of commands, slowing down: before bends, the goal, and at an order to stand");
  field("emergency_deceleration", emergency_deceleration, {1e-3, 1e6}, "m/s^2",
        "of commands, where the pose must not be driven by");
  field("max_steering_rate", max_steering_rate, {1e-3, 1e6}, "rad/s", "of the commanded steering angle");
}

MotionCommand CommandLimiter::limited(const MotionCommand& wanted, bool urgent, double duration) {
  const double dt = duration > 0.0 ? std::min(duration, kLongestStep) : 0.0;
  const bool stopping = wanted.speed == 0.0 && last_.speed != 0.0;
  const bool faster = std::abs(wanted.speed) > std::abs(last_.speed);
  const double brake =
      urgent ? std::max(limits_.emergency_deceleration, limits_.max_deceleration) : limits_.max_deceleration;
  const double angle = stopping ? last_.steering_angle : wanted.steering_angle;
  last_.speed = approach(last_.speed, wanted.speed, (faster ? limits_.max_acceleration : brake) * dt);
  last_.steering_angle = approach(last_.steering_angle, angle, limits_.max_steering_rate * dt);
  return last_;
}

Pose2 CommandLimiter::carried_forward(const Pose2& pose, double age) const {
  if (!pose.finite() || !(age > 0.0) || !std::isfinite(age)) return pose;
  return pose * displacement({0.0, age, last_.speed, yaw_rate(last_, wheelbase_)});
}

}  // namespace multipath_localization
