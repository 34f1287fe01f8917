#include "multipath_localization/guidance/waypoint_file.hpp"
#include "oracle.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

constexpr double kRounding = 1e-4;  // [m], [deg]

bool can_be_driven_to(const Eigen::Vector2d& point, bool on_earth) {
  if (on_earth) return valid(Geodetic{point.x(), point.y()});
  return point.allFinite() && point.lpNorm<Eigen::Infinity>() <= kFarthestWaypoint;
}

void check(const WaypointList& list, const std::string& ending) {
  require(list.points.size() <= kMostWaypoints, "too many waypoints");
  for (const Eigen::Vector2d& point : list.points) {
    require(can_be_driven_to(point, list.on_earth), "a waypoint that cannot be driven to");
  }
  if (list.points.empty()) return;
  const std::string file = written("written" + ending, "");
  write_waypoints(file, list);
  const auto again = read_waypoints(file);
  require(again && again->on_earth == list.on_earth && again->points.size() == list.points.size(),
          "waypoints are others once written and read again");
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    require((again->points[i] - list.points[i]).norm() <= kRounding, "a waypoint has moved by being written");
  }
}

void check_in_map(const WaypointList& list) {
  const auto points = unless_refused<std::invalid_argument>([&] {
    return to_map(list, LocalFrame(Geodetic{52.5, 13.4, 40.0}));
  });
  if (!points) return;
  for (const Eigen::Vector2d& point : *points) {
    require(point.lpNorm<Eigen::Infinity>() <= kFarthestWaypoint, "a waypoint out of reach");
  }
}

}  // namespace

void waypoints(const std::string& bytes) {
  for (const std::string ending : {".csv", ".yaml", ".geojson", ".kml", ".gpx", ".plan", ".waypoints"}) {
    const auto list =
        unless_refused<ParameterError>([&] { return read_waypoints(written("waypoints" + ending, bytes)); });
    if (!list) continue;
    require(list->has_value(), "the file is there");
    check(**list, ending == ".csv" || ending == ".yaml" ? ending : ".geojson");
    check_in_map(**list);
  }
}

}  // namespace multipath_localization::fuzz
