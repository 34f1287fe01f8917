#pragma once

#include <string>

#include "multipath_localization/guidance/waypoint_file.hpp"

namespace multipath_localization {

/// The columns `x,y` [m] or `latitude,longitude` [deg], named in the first line; `#` begins a comment. Throws
/// ParameterError, `FILE:LINE: reason`.
WaypointList read_csv_waypoints(const std::string& file);

/// The same list as text, to 0.1 mm.
std::string csv_of(const WaypointList& waypoints);

}  // namespace multipath_localization
