#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {

/// The waypoints with their numbers from 1, the way between them, and the one steered for.
visualization_msgs::MarkerArray waypoint_markers(const WaypointFollower& follower, const std::string& frame);

}  // namespace multipath_localization
