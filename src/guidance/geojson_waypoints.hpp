#pragma once

#include <string>

#include "multipath_localization/guidance/waypoint_file.hpp"

namespace multipath_localization {

/// GeoJSON (RFC 7946): a LineString, or the outer ring of a Polygon, or points; see MapFeatures for which of
/// them is the route. Throws ParameterError, `FILE:feature N: reason`, on any other geometry too, and on
/// another reference system than WGS 84.
WaypointList read_geojson_waypoints(const std::string& file);

/// A feature with one LineString, to 0.1 mm; with a Point where there is one waypoint. Throws ParameterError
/// where the list is empty, or in x and y of a map whose origin is not known.
std::string geojson_of(const WaypointList& waypoints);

}  // namespace multipath_localization
