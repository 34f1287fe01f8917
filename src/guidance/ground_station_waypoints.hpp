#pragma once

#include <string>

#include "multipath_localization/guidance/waypoint_file.hpp"

namespace multipath_localization {

/// A plan of QGroundControl (.plan): its waypoints (MAV_CMD_NAV_WAYPOINT). Throws ParameterError,
/// `FILE:item N: reason`, on any other item, which would not be carried out, and where it has a geofence,
/// which would not be kept.
WaypointList read_plan_waypoints(const std::string& file);

/// A mission as text (.waypoints, "QGC WPL 110"), as Mission Planner and others write it: its waypoints. The
/// first line is the home position, and left out, where it alone is of MAV_FRAME_GLOBAL. Throws
/// ParameterError, `FILE:LINE: reason`, on any other item.
WaypointList read_mission_waypoints(const std::string& file);

}  // namespace multipath_localization
