#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "guidance/rounded_way.hpp"

namespace multipath_localization {

/// A field to be worked on in strips.
struct Field {
  std::vector<Eigen::Vector2d> border;           ///< its corners in map [m], either way round
  double width;                                  ///< of a strip: the tool's, and the robot's at least [m]
  std::optional<double> heading = std::nullopt;  ///< of the tracks [rad]; none: along the longest edge
};

/// A way over a field for a base that turns by `turning_radius` [m] at least, from the corner nearest to
/// `start` on. First it goes round along the border, half a width within, as often as the turns between
/// tracks take room; then up and down by parallel tracks. Its centre comes nowhere nearer to the border than
/// half a width. From track to track it drives along the border, by arcs and loops the base can drive; of
/// tracks too near to each other for that it takes another first.
///
/// Throws std::invalid_argument where the border is no simple polygon, where the field is narrower than the
/// width somewhere, and where the base cannot turn at a corner of it.
std::vector<WayPoint> coverage_of(const Field& field, double turning_radius, const Eigen::Vector2d& start);

}  // namespace multipath_localization
