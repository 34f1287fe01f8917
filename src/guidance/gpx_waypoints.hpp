#pragma once

#include <string>

#include "multipath_localization/guidance/waypoint_file.hpp"

namespace multipath_localization {

/// GPX: its route (rte), else its track (trk), its segments one after the other, else its waypoints (wpt) in
/// their order. Throws ParameterError, `FILE:LINE: reason`; where there are several routes, or tracks, too.
WaypointList read_gpx_waypoints(const std::string& file);

}  // namespace multipath_localization
