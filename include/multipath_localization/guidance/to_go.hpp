#pragma once

#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {

/// What is left of a route, or of the round under way.
struct ToGo {
  double distance = 0.0;  ///< [m]
  double time = 0.0;      ///< with the waits on the way; infinity where one ends by call alone [s]
};

/// Along the path as far as it is laid, at the speeds planned there; beyond, straight from waypoint to
/// waypoint at the speeds told.
ToGo to_go(const WaypointFollower& follower, double cruise_speed);

}  // namespace multipath_localization
