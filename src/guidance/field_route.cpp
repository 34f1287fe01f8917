#include "multipath_localization/guidance/field_route.hpp"

#include <algorithm>
#include <stdexcept>

#include "guidance/field_coverage.hpp"

namespace multipath_localization {

namespace {

constexpr double kWider = 1.2;           // arcs than the tightest the base can drive: what is left steers
constexpr double kSmallestRadius = 0.3;  // of arcs: a differential base turns as tightly as it likes [m]

}  // namespace

FieldRoute field_route(const std::vector<Eigen::Vector2d>& border, const FieldTask& task,
                       const Eigen::Vector2d& start, const WaypointFollowerParameters& parameters) {
  const double radius = std::max(kWider / parameters.tightest_curvature(), kSmallestRadius);
  const std::vector<WayPoint> way = coverage_of({border, task.width, task.heading}, radius, start);
  if (way.size() > kMostWaypoints) throw std::invalid_argument("the field takes too many waypoints");
  FieldRoute route;
  route.tasks.once = true;
  for (const WayPoint& place : way) {
    route.waypoints.push_back(place.position);
    WaypointTask on_the_way;
    on_the_way.speed = task.speed;
    on_the_way.curvature = place.curvature;
    route.tasks.at.push_back(on_the_way);
  }
  return route;
}

}  // namespace multipath_localization
