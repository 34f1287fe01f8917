#pragma once

#include <optional>

#include "multipath_localization/guidance/command_limiter.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"
#include "ros/steering_node/moment.hpp"

namespace multipath_localization {

/// The commands that leave, one after the other: within the base's limits, and to a stand even where no pose
/// comes any more. When the robot stands by order, or at the end of the way, zero leaves for a second only:
/// others may drive it then.
class CommandStream {
 public:
  explicit CommandStream(const WaypointFollowerParameters& parameters)
      : limiter_(parameters.limits, parameters.wheelbase) {}

  /// The command towards what is wanted now; nothing where the robot `stands` and is left to others.
  std::optional<MotionCommand> towards(const FollowerOutput& wanted, bool stands, const Moment& now);

  /// The next command to a stand, by what was wanted last; nothing unless it is being braked.
  std::optional<MotionCommand> braked(const Moment& now);

  /// A command of zero that is given whatever the limits.
  MotionCommand halted();

  /// Zero is to be said again to a robot that stands, whoever drives it.
  void speak_again() { standing_since_ = {}; }

  [[nodiscard]] const CommandLimiter& limiter() const { return limiter_; }

 private:
  bool leaves_to_others(bool stands, const ros::SteadyTime& now);
  MotionCommand brake(const Moment& now);
  /// Since the last command [s]; no stop waits for a clock that stands still.
  double step_to(const Moment& now);

  CommandLimiter limiter_;
  Moment commanded_;                ///< when the last command left
  ros::SteadyTime standing_since_;  ///< by order; zero while it is to drive
  bool stopping_ = false;           ///< braking to a stand
  bool urgent_ = false;             ///< that, because the pose must not be driven by
};

}  // namespace multipath_localization
