#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace multipath_localization {

/// A simple polygon in the map frame, its corners in either sense of rotation [m].
class Polygon {
 public:
  Polygon() = default;

  /// From coordinates [x0, y0, x1, y1, ...]. Throws ParameterError, naming `owner`, unless there are at least
  /// three pairs.
  Polygon(const std::vector<double>& coordinates, const std::string& owner);

  [[nodiscard]] bool contains(const Eigen::Vector2d& point) const;

  /// Distance to the nearest edge [m], positive inside, negative outside.
  [[nodiscard]] double depth(const Eigen::Vector2d& point) const;

  /// The sense of rotation of the corners.
  [[nodiscard]] bool counter_clockwise() const;

  /// The area cut into triangles, three corners each, counter-clockwise; for drawing.
  [[nodiscard]] std::vector<Eigen::Vector2d> triangles() const;

  [[nodiscard]] const std::vector<Eigen::Vector2d>& corners() const { return corners_; }

 private:
  std::vector<Eigen::Vector2d> corners_;
};

}  // namespace multipath_localization
