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
  double max_steering_rate = 1.5;
  double max_yaw_rate = 1.0;
  double max_yaw_acceleration = 2.0;

  void fields(ParameterVisitor& field);

  /// Whether it turns by the speeds of its wheels or tracks, on the spot too.
  [[nodiscard]] bool differential() const { return base == "differential"; }
};

/// Keeps commands within what a base can follow. A stop is braked to along the arc the base is on. The
/// steering angle of a differential base is that of a front wheel `wheelbase` ahead which turns as it does.
class CommandLimiter {
 public:
  /// `last` is the command the base has: rest, as a rule.
  CommandLimiter(const CommandLimits& limits, double wheelbase, const MotionCommand& last = {});

  /// The command `duration` [s] after the last one, on the way to the `wanted` one;
  /// kLongestStep of a longer silence count. An urgent stop brakes by `emergency_deceleration`. A
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
  CommandLimits limits_;
  double wheelbase_;
  MotionCommand last_;
  double yaw_rate_ = 0.0;
};

}  // namespace multipath_localization
