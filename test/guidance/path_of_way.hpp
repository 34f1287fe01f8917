#pragma once

#include <Eigen/Core>
#include <vector>

#include "guidance/rounded_way.hpp"
#include "multipath_localization/guidance/path.hpp"

namespace multipath_localization {

/// The path along the lines and arcs of a way.
inline Path path_of(const std::vector<WayPoint>& way) {
  std::vector<Eigen::Vector2d> places;
  std::vector<double> curvatures;
  for (const WayPoint& place : way) {
    places.push_back(place.position);
    curvatures.push_back(place.curvature);
  }
  return {places, curvatures, 1.0};
}

}  // namespace multipath_localization
