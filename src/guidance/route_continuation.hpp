#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace multipath_localization {

constexpr double kSameWaypoint = 0.05;  ///< two waypoints as near as this are one [m]

/// Whether two routes in map [m] have as many waypoints, each within kSameWaypoint of the other's.
bool same_route(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b);

/// Index in `after` of the waypoint that a robot steers for which has passed the first `passed` waypoints of
/// `before`, where `after` continues `before`: it begins with waypoints just passed, some or none, and goes
/// on with the one steered for. What follows may be another way. A route passed as a whole is continued by
/// what has more waypoints behind all of its own. Nothing where `after` is another route.
std::optional<std::size_t> target_in_continuation(const std::vector<Eigen::Vector2d>& before,
                                                  std::size_t passed,
                                                  const std::vector<Eigen::Vector2d>& after);

}  // namespace multipath_localization
