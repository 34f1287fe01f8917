#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace multipath_localization {

/// A place of a way in map [m], and how it is gone to.
struct WayPoint {
  Eigen::Vector2d position;
  double curvature;  ///< of the arc from the place before, of half a circle at most, to the left; 0: straight
                     ///< [1/m]
};

/// How corners of a way are driven round.
struct Rounding {
  double radius;                                         ///< of its arcs [m]
  std::function<bool(const Eigen::Vector2d&)> may_come;  ///< whether to a place in map [m]
};

/// A way of straight lines from corner to corner in map [m], with arcs that touch them: of the places where
/// lines and arcs meet. A corner whose arc would come where it may not is driven round on a loop to the other
/// side: straight over the corner and round until the way on lies ahead. None where a loop may not come there
/// either, or where the lines are too short for the arcs.
std::optional<std::vector<WayPoint>> rounded_way(const std::vector<Eigen::Vector2d>& corners,
                                                 const Rounding& rounding);

}  // namespace multipath_localization
