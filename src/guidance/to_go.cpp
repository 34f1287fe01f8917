#include "multipath_localization/guidance/to_go.hpp"

#include <algorithm>

namespace multipath_localization {

namespace {

/// As far as the path leads through the next `count` waypoints.
ToGo along_path(const PathDriver& driver, std::size_t count) {
  const PathProgress& progress = driver.progress();
  const double from = progress.station();
  const double to = std::max(from, progress.station_ahead(count - 1));
  const Path& path = progress.path();
  return {to - from, driver.speed().duration(path, from, to)};
}

}  // namespace

ToGo to_go(const WaypointFollower& follower, double cruise_speed) {
  const Route& route = follower.route();
  if (route.empty() || follower.finished()) return {};
  const std::size_t left = route.waypoints().size() - route.target();
  const PathDriver* driver = follower.driver();
  const std::size_t on_path = driver == nullptr ? 0 : std::min(left, driver->progress().left());
  ToGo sum = on_path > 0 ? along_path(*driver, on_path) : ToGo{};
  for (std::size_t i = 0; i < left; ++i) {
    if (i + 1 < left) sum.time += route.task(i).wait;
    if (i < on_path || i == 0) continue;
    const double leg = (route.waypoint(i) - route.waypoint(i - 1)).norm();
    sum.distance += leg;
    sum.time += leg / std::min(cruise_speed, route.task(i).speed);
  }
  return sum;
}

}  // namespace multipath_localization
