#pragma once

#include <Eigen/Core>
#include <vector>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// The outline of a base from above: a rectangle about its origin.
struct Footprint {
  double front = 0.7;
  double rear = 0.2;
  double width = 0.6;
  double side_clearance = 0.1;

  void fields(ParameterVisitor& field);

  /// Whether a point in the base [m] lies in the outline, as much wider to both sides as told.
  [[nodiscard]] bool holds(const Eigen::Vector2d& point, double wider = 0.0) const;
  /// Of the circle that the outline stays in when the base turns on the spot [m].
  [[nodiscard]] double radius() const;
};

/// How far a base gets along `way`, poses that follow each other, one at least, before its outline, wider by
/// its clearance, comes over one of the obstacles, all in one frame [m]; infinity where it never does. What
/// is within the clearance at the beginning counts against the outline alone, so that the base gets out of
/// narrow places.
double free_way(const std::vector<Pose2>& way, const Footprint& footprint,
                const std::vector<Eigen::Vector2d>& obstacles);

/// Whether a base at that pose touches none of the obstacles however it turns on the spot.
bool free_to_turn(const Pose2& pose, const Footprint& footprint,
                  const std::vector<Eigen::Vector2d>& obstacles);

}  // namespace multipath_localization
