#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {

/// The waypoints with their numbers from 1, the way along them, and the one steered for. The way is the path
/// that is driven, from red at rest to green at the cruise speed [m/s], where one is laid.
visualization_msgs::MarkerArray waypoint_markers(const WaypointFollower& follower, const std::string& frame,
                                                 double cruise_speed);

}  // namespace multipath_localization
