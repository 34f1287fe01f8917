#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/guidance/route.hpp"

namespace multipath_localization {

constexpr std::size_t kMostWaypoints = 10000;
constexpr double kFarthestWaypoint =
    100e3;  ///< of map's origin, east or north [m]: there the Earth is curved

/// What is to be done where the points are the border of a field to be worked on in strips.
struct FieldTask {
  double width;                                     ///< of a strip [m]
  std::optional<double> heading = std::nullopt;     ///< of the tracks, counter-clockwise from east [rad]
  std::optional<std::size_t> start = std::nullopt;  ///< the corner to begin at; none: the nearest
  double speed = std::numeric_limits<double>::infinity();  ///< at most [m/s]
};

/// Places to drive to, as their owner wrote them down.
struct WaypointList {
  bool on_earth = false;  ///< the points are latitude and longitude [deg], else x and y in map [m]
  std::vector<Eigen::Vector2d> points;            ///< kMostWaypoints at most
  std::optional<LocalFrame> map = std::nullopt;   ///< that x and y are in, when known
  std::vector<WaypointTask> tasks = {};           ///< one for each point, or none at all
  std::optional<FieldTask> field = std::nullopt;  ///< the points are its border, no waypoints
};

/// The same places on the ground with x and y in `map`; as they are where they are on Earth, or where one of
/// the two maps is not known. Throws std::invalid_argument where `map` cannot hold one, naming the first.
WaypointList moved(const WaypointList& waypoints, const std::optional<LocalFrame>& map);

/// The points in `map` [m], where they are on the ground when they were written down in another. Throws
/// std::invalid_argument where these are not known yet, `map` being needed and not there, where there are
/// more than kMostWaypoints, and where one cannot be driven to, naming the first.
std::vector<Eigen::Vector2d> to_map(const WaypointList& waypoints, const std::optional<LocalFrame>& map);

/// Appends a point of `map` [m], by latitude and longitude where the others are or where it is the first and
/// `map` is known: such a list holds on another day, whatever map's origin then is. One in x and y is moved
/// to `map`. Throws std::invalid_argument on a point that cannot be driven to, above kMostWaypoints, and
/// where `map` is needed and not there, and to a field.
void append(WaypointList& waypoints, const Eigen::Vector2d& in_map, const std::optional<LocalFrame>& map);

/// Waypoints of a file, in the order of driving; all of one kind. By its ending:
///
/// - .csv: the columns `x,y` or `latitude,longitude`, named in the first line; `#` begins a comment
/// - .yaml, .yml: `waypoints:`, a list of `[x, y]`, `{x: , y: }` or `{latitude: , longitude: }`, the latter
///   two with `speed`, `wait` (seconds, or `resume`) and `reverse` as wanted, see WaypointTask; or `field:`,
///   a FieldTask, with its `border`
/// - .geojson, .json, .kml: a line, or the outer ring of a polygon, else the points; a polygon of GeoJSON
///   with the property `coverage_width` is a field
/// - .gpx: the route, else the track, else the waypoints
/// - .plan, .waypoints: what QGroundControl, Mission Planner and others save, of waypoints alone
///
/// A ring is driven round by `loop`. Nothing where there is no such file. Throws ParameterError,
/// `FILE:LINE: reason`, on the first part that is anything else.
std::optional<WaypointList> read_waypoints(const std::string& file);

/// The entries of a list [[x, y], ...] as points in map [m]. Throws ParameterError, naming `path`.
std::vector<Eigen::Vector2d> load_points(const YAML::Node& source, const std::string& path);

/// Writes a file of waypoints, .csv, .yaml or .geojson, to 0.1 mm; it is replaced as a whole. Throws
/// ParameterError on another ending, on tasks, which .yaml alone holds, or where GeoJSON cannot hold the
/// list, which is then empty or in x and y of a map whose origin is not known, and std::system_error where it
/// cannot write.
void write_waypoints(const std::string& file, const WaypointList& waypoints);

}  // namespace multipath_localization
