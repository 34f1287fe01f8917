#include "guidance/rehearsal.hpp"

#include <cmath>
#include <limits>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/guidance/command_limiter.hpp"

namespace multipath_localization {

namespace {

constexpr double kStep = 0.05;      // [s]
constexpr double kLongest = 600.0;  // [s]

}  // namespace

double rehearsed_miss(PathDriver driver, Pose2 pose, const MotionCommand& last,
                      const WaypointFollowerParameters& parameters) {
  const double lag = parameters.steering_lag;
  const double share = lag > 0.0 ? -std::expm1(-kStep / lag) : 1.0;
  CommandLimiter limiter(parameters.limits, parameters.wheelbase, last);
  double angle = last.steering_angle;
  for (double time = 0.0; time < kLongest; time += kStep) {
    if (driver.passes(pose)) return (pose.position() - driver.progress().end()).norm();
    const PathCommand wanted = driver.command(pose, parameters.cruise_speed);
    const MotionCommand command = limiter.limited(wanted.command, false, kStep, wanted.spin);
    angle += share * (command.steering_angle - angle);
    const double turn = yaw_rate({command.speed, angle}, parameters.wheelbase);
    pose = pose * displacement({0.0, kStep, command.speed, turn});
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace multipath_localization
