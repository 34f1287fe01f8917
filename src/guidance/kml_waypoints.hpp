#pragma once

#include <string>

#include "multipath_localization/guidance/waypoint_file.hpp"

namespace multipath_localization {

/// KML, as Google Earth writes it: a LineString, or the outer ring of a Polygon, or points; see MapFeatures
/// for which of them is the route. Throws ParameterError, `FILE:LINE: reason`.
WaypointList read_kml_waypoints(const std::string& file);

}  // namespace multipath_localization
