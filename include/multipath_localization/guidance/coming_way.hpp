#pragma once

#include <vector>

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {

/// The poses that a base at `pose` takes next over `length` [m], its own first: along the path where it
/// follows one, else on the arc of `wanted`.
std::vector<Pose2> coming_way(const WaypointFollower& follower, const WaypointFollowerParameters& parameters,
                              const Pose2& pose, const MotionCommand& wanted, double length);

}  // namespace multipath_localization
