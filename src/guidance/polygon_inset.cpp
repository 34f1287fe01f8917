#include "guidance/polygon_inset.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <optional>
#include <utility>

namespace multipath_localization {

namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point, false>;  // counter-clockwise

constexpr double kNoCorner = 1e-3;  // farther aside of the line between its neighbours a corner is one [m]
constexpr double kSharpest = 3.0;   // a corner that points inwards juts out so many distances at most

Polygon polygon_of(const std::vector<Eigen::Vector2d>& corners) {
  Polygon polygon;
  for (const Eigen::Vector2d& corner : corners) bg::append(polygon.outer(), Point(corner.x(), corner.y()));
  bg::correct(polygon);
  return polygon;
}

/// Whether `corner` lies on the line between its neighbours.
bool is_straight(const Eigen::Vector2d& before, const Eigen::Vector2d& corner, const Eigen::Vector2d& after) {
  const Eigen::Vector2d way = after - before;
  const Eigen::Vector2d to_corner = corner - before;
  return std::abs(way.x() * to_corner.y() - way.y() * to_corner.x()) <= kNoCorner * way.norm();
}

/// None where nothing but a sliver is left.
std::optional<Ring> ring_of(const Polygon& polygon) {
  std::vector<Eigen::Vector2d> corners;
  for (const Point& point : polygon.outer()) corners.emplace_back(point.x(), point.y());
  corners.pop_back();  // the first again
  for (std::size_t i = 0; i < corners.size() && corners.size() > 2;) {
    const std::size_t count = corners.size();
    const bool straight = is_straight(corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count]);
    if (straight) corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
    i = straight ? (i > 0 ? i - 1 : 0) : i + 1;
  }
  return corners.size() > 2 ? std::optional<Ring>(std::in_place, corners) : std::nullopt;
}

}  // namespace

std::string fault_of_polygon(const std::vector<Eigen::Vector2d>& corners) {
  if (corners.size() < 3) return "fewer than three corners";
  const bool finite =
      std::all_of(corners.begin(), corners.end(), [](const auto& c) { return c.allFinite(); });
  if (!finite) return "a corner that is not finite";
  const Polygon polygon = polygon_of(corners);
  if (bg::intersects(polygon)) return "edges that cross or touch";
  return bg::is_valid(polygon) ? "" : "no area inside";
}

std::vector<Ring> inset(const Ring& ring, double distance) {
  bg::model::multi_polygon<Polygon> parts;
  bg::buffer(polygon_of(ring.corners()), parts, bg::strategy::buffer::distance_symmetric<double>(-distance),
             bg::strategy::buffer::side_straight(), bg::strategy::buffer::join_miter(kSharpest),
             bg::strategy::buffer::end_flat(), bg::strategy::buffer::point_square());
  std::vector<Ring> rings;
  for (const Polygon& part : parts) {
    if (const auto of_part = ring_of(part)) rings.push_back(*of_part);
  }
  return rings;
}

}  // namespace multipath_localization
