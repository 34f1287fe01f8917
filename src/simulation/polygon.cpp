#include "multipath_localization/simulation/polygon.hpp"

#include <algorithm>
#include <limits>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

double distance_to_edge(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d edge = b - a;
  const double length = edge.squaredNorm();
  const double along = length > 0.0 ? std::clamp((point - a).dot(edge) / length, 0.0, 1.0) : 0.0;
  return (point - a - along * edge).norm();
}

}  // namespace

Polygon::Polygon(const std::vector<double>& coordinates, const std::string& owner) {
  if (coordinates.size() < 6 || coordinates.size() % 2 != 0) {
    throw ParameterError("corners of " + owner + " are not three or more pairs x, y");
  }
  for (std::size_t i = 0; i < coordinates.size(); i += 2) {
    corners_.emplace_back(coordinates[i], coordinates[i + 1]);
  }
}

bool Polygon::contains(const Eigen::Vector2d& point) const {
  bool inside = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Eigen::Vector2d& a = corners_[i];
    const Eigen::Vector2d& b = corners_[(i + 1) % corners_.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double crossing = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (point.x() < crossing) inside = !inside;
  }
  return inside;
}

double Polygon::depth(const Eigen::Vector2d& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    nearest = std::min(nearest, distance_to_edge(point, corners_[i], corners_[(i + 1) % corners_.size()]));
  }
  return contains(point) ? nearest : -nearest;
}

}  // namespace multipath_localization
