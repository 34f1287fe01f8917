#pragma once

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// How fast a base's commands may change.
struct CommandLimits {
  double max_acceleration = 1.0;
  double max_deceleration = 1.0;
  double emergency_deceleration = 2.0;
  double max_steering_rate = 1.5;

  void fields(ParameterVisitor& field);
};

/// Keeps commands within what a base can follow. A stop is braked to with the front wheel held: along the
/// arc the base is on.
class CommandLimiter {
 public:
  CommandLimiter(const CommandLimits& limits, double wheelbase) : limits_(limits), wheelbase_(wheelbase) {}

  /// The command `duration` [s] after the last one, the first being rest, on the way to the `wanted` one;
  /// kLongestStep of a longer silence count. An urgent stop brakes by `emergency_deceleration`.
  MotionCommand limited(const MotionCommand& wanted, bool urgent, double duration);

  /// A command that is given whatever the limits: at rest.
  void halt() { last_ = {}; }

  [[nodiscard]] const MotionCommand& last() const { return last_; }

  /// Where a base at `pose` in map, `age` [s] ago, is now by the last command.
  [[nodiscard]] Pose2 carried_forward(const Pose2& pose, double age) const;

  static constexpr double kLongestStep = 0.2;  ///< [s] commands come more often than at 5 Hz

 private:
  CommandLimits limits_;
  double wheelbase_;
  MotionCommand last_;
};

}  // namespace multipath_localization
