#include "simulation/polygon.hpp"

#include <algorithm>
#include <limits>

#include "multipath_localization/core/parameters.hpp"
#include "support/plane.hpp"

namespace multipath_localization {

namespace {

double distance_to_edge(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d edge = b - a;
  const double length = edge.squaredNorm();
  const double along = length > 0.0 ? std::clamp((point - a).dot(edge) / length, 0.0, 1.0) : 0.0;
  return (point - a - along * edge).norm();
}

/// Twice the signed area of a triangle, positive counter-clockwise.
double doubled_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return cross(b - a, c - a);
}

/// Whether the triangle at corner `i` of a counter-clockwise outline can be cut off.
bool is_ear(const std::vector<Eigen::Vector2d>& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const Eigen::Vector2d& a = outline[(i + n - 1) % n];
  const Eigen::Vector2d& b = outline[i];
  const Eigen::Vector2d& c = outline[(i + 1) % n];
  if (doubled_area(a, b, c) <= 0.0) return false;
  return std::none_of(outline.begin(), outline.end(), [&](const Eigen::Vector2d& p) {
    const bool own = p == a || p == b || p == c;
    return !own && doubled_area(a, b, p) >= 0.0 && doubled_area(b, c, p) >= 0.0 &&
           doubled_area(c, a, p) >= 0.0;
  });
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

bool Polygon::counter_clockwise() const {
  double doubled = 0.0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    doubled += cross(corners_[i], corners_[(i + 1) % corners_.size()]);
  }
  return doubled > 0.0;
}

std::vector<Eigen::Vector2d> Polygon::triangles() const {
  std::vector<Eigen::Vector2d> outline = corners_;
  if (!counter_clockwise()) std::reverse(outline.begin(), outline.end());
  std::vector<Eigen::Vector2d> all;
  while (outline.size() >= 3) {
    const std::size_t n = outline.size();
    std::size_t ear = 0;
    while (ear + 1 < n && !is_ear(outline, ear)) ++ear;
    for (const std::size_t corner : {ear + n - 1, ear, ear + 1}) all.push_back(outline[corner % n]);
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return all;
}

}  // namespace multipath_localization
