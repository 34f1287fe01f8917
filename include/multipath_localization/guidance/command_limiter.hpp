#pragma once

#include <string>

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// What a base is, and how fast its commands may change.
struct CommandLimits {
  std::string base = "front_steering";
  double max_acceleration = 1.0;
  double max_deceleration = 1.0;
  double emergency_deceleration = 2.0;
  double max_jerk = 5.0;
  double max_steering_rate = 1.5;
  double max_yaw_rate = 1.0;
  double max_yaw_acceleration = 2.0;

  void fields(ParameterVisitor& field);

  /// Whether it turns by the speeds of its wheels or tracks, on the spot too.
  [[nodiscard]] bool differential() const { return base == "differential"; }
  /// By how much earlier a base that speeds up has to begin to brake by `deceleration` [m/s^2], as that sets
  /// in by `max_jerk` [s].
  [[nodiscard]] double braking_delay(double deceleration) const;
};

/// Keeps commands within what a base can follow. A stop is braked to along the arc the base is on. The
/// steering angle of a differential base is that of a front wheel `wheelbase` ahead which turns as it does.
class CommandLimiter {
 public:
  /// `last` is the command the base has: rest, as a rule.
  CommandLimiter(const CommandLimits& limits, double wheelbase, const MotionCommand& last = {});

  /// The command `duration` [s] after the last one, on the way to the `wanted` one;
  /// kLongestStep of a longer silence count. An urgent stop brakes by `emergency_deceleration` at once. A
  /// differential base at rest turns on the spot, at `spin` [rad/s].
  MotionCommand limited(const MotionCommand& wanted, bool urgent, double duration, double spin = 0.0);

  /// A command that is given whatever the limits: at rest.
  void halt();

  [[nodiscard]] const MotionCommand& last() const { return last_; }
  [[nodiscard]] bool at_rest() const { return last_.speed == 0.0 && yaw_rate_ == 0.0; }
  [[nodiscard]] double yaw_rate() const { return yaw_rate_; }  ///< of the last command [rad/s]

  /// Where a base at `pose` in map, `age` [s] ago, is now by the last command.
  [[nodiscard]] Pose2 carried_forward(const Pose2& pose, double age) const;

  static constexpr double kLongestStep = 0.2;  ///< [s] commands come more often than at 5 Hz

 private:
  [[nodiscard]] double next_speed(double wanted, double dt);
  [[nodiscard]] double next_speed_urgently(double wanted, double dt);

  CommandLimits limits_;
  double wheelbase_;
  MotionCommand last_;
  double acceleration_ = 0.0;  ///< by the last command [m/s^2]
  double yaw_rate_ = 0.0;
};

}  // namespace multipath_localization
