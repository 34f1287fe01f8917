#pragma once

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// Where a robot at `pose` is after `duration` [s] of a command, obeyed exactly.
inline Pose2 driven(const Pose2& pose, const MotionCommand& u, double wheelbase, double duration) {
  return pose * displacement({0.0, duration, u.speed, yaw_rate(u, wheelbase)});
}

}  // namespace multipath_localization
