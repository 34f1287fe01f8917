#pragma once

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/guidance/path_driver.hpp"
#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"

namespace multipath_localization {

/// How far from the end of its path a base passes it [m] that is driven there from `pose` on, the command
/// `last` being under way, by a copy of `driver`: within the limits of `parameters`, its steering late by
/// `steering_lag`. Infinity where it does not come there within ten minutes.
double rehearsed_miss(PathDriver driver, Pose2 pose, const MotionCommand& last,
                      const WaypointFollowerParameters& parameters);

}  // namespace multipath_localization
