#pragma once

#include <string>

#include "multipath_localization/guidance/waypoint_file.hpp"

namespace multipath_localization {

/// `waypoints:`, a list of `[x, y]`, `{x: , y: }` [m] or `{latitude: , longitude: }` [deg], or `field:`, with
/// `border`, such a list, `width`, and `heading`, `start` and `speed` as wanted, see FieldTask. Throws
/// ParameterError, `FILE:LINE: reason`.
WaypointList read_yaml_waypoints(const std::string& file);

/// The same list as text, to 0.1 mm.
std::string yaml_of(const WaypointList& waypoints);

}  // namespace multipath_localization
