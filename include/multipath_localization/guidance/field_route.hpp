#pragma once

#include <Eigen/Core>
#include <vector>

#include "multipath_localization/guidance/route.hpp"
#include "multipath_localization/guidance/waypoint_file.hpp"
#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"

namespace multipath_localization {

/// A way over a field.
struct FieldRoute {
  std::vector<Eigen::Vector2d> waypoints;  ///< in map [m]
  RouteTasks tasks;                        ///< once
};

/// The way over the field within a border in map [m] that a base of these parameters can drive, from the
/// corner nearest to `start` on: round along the border, then up and down by parallel tracks, see
/// coverage_of. Throws std::invalid_argument as that does, and where the way takes more than kMostWaypoints.
FieldRoute field_route(const std::vector<Eigen::Vector2d>& border, const FieldTask& task,
                       const Eigen::Vector2d& start, const WaypointFollowerParameters& parameters);

}  // namespace multipath_localization
