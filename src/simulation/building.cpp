#include "simulation/building.hpp"

#include "simulation/polygon.hpp"

namespace multipath_localization {

void BuildingParameters::fields(ParameterVisitor& field) {
  field("name", name, {}, "what to call it");
  field("corners", corners, {-1e6, 1e6}, "m", "x0, y0, x1, y1, ... in map");
  field("height", height, {0.0, 1e4}, "m", "above the ground");
}

std::vector<Wall> walls(const BuildingParameters& building) {
  const Polygon outline(building.corners, "building " + building.name);
  const double sense = outline.counter_clockwise() ? 1.0 : -1.0;
  const std::vector<Eigen::Vector2d>& corners = outline.corners();
  std::vector<Wall> all;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d edge = corners[(i + 1) % corners.size()] - corners[i];
    if (edge.isZero()) continue;
    const Eigen::Vector2d along = edge.normalized();
    all.push_back(
        {corners[i], along, sense * Eigen::Vector2d(along.y(), -along.x()), edge.norm(), building.height});
  }
  return all;
}

}  // namespace multipath_localization
