#include "ros/simulator_node/world_markers.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

using visualization_msgs::Marker;

constexpr double kHalfPlaneReach = 100.0;  // [m]
constexpr double kZoneHeight = -0.02;      // below the tracks [m]

geometry_msgs::Point point(const Eigen::Vector2d& position, double z) {
  geometry_msgs::Point message;
  message.x = position.x();
  message.y = position.y();
  message.z = z;
  return message;
}

Marker triangles(const std_msgs::Header& header, const std::string& ns, std::size_t id) {
  Marker marker;
  marker.header = header;
  marker.ns = ns;
  marker.id = static_cast<int>(id);
  marker.type = Marker::TRIANGLE_LIST;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  return marker;
}

void colour(Marker& marker, float r, float g, float b, float a) {
  marker.color.r = r;
  marker.color.g = g;
  marker.color.b = b;
  marker.color.a = a;
}

Polygon outline(const ZoneParameters& zone) {
  if (zone.shape == ZoneShape::kPolygon) return Polygon(zone.corners, "zone " + zone.name);
  const Eigen::Vector2d edge(zone.edge_x, zone.edge_y);
  const Eigen::Vector2d inward(std::cos(zone.inward), std::sin(zone.inward));
  const Eigen::Vector2d along(-inward.y(), inward.x());
  std::vector<double> corners;
  for (const auto& [in, side] : {std::pair{0.0, -1.0}, {2.0, -1.0}, {2.0, 1.0}, {0.0, 1.0}}) {
    const Eigen::Vector2d corner = edge + kHalfPlaneReach * (in * inward + side * along);
    corners.push_back(corner.x());
    corners.push_back(corner.y());
  }
  return {corners, "zone " + zone.name};
}

Marker ground(const ZoneParameters& zone, const std_msgs::Header& header, std::size_t id) {
  Marker marker = triangles(header, "shadow zones", id);
  for (const Eigen::Vector2d& corner : outline(zone).triangles()) {
    marker.points.push_back(point(corner, kZoneHeight));
  }
  colour(marker, 0.25F, 0.25F, 0.55F, 0.35F);
  return marker;
}

Marker prism(const BuildingParameters& building, const std_msgs::Header& header, std::size_t id) {
  Marker marker = triangles(header, "buildings", id);
  const Polygon base(building.corners, "building " + building.name);
  for (const Eigen::Vector2d& corner : base.triangles())
    marker.points.push_back(point(corner, building.height));
  const std::vector<Eigen::Vector2d>& corners = base.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    for (const auto& [corner, z] : {std::pair{a, 0.0}, {b, 0.0}, {b, building.height}}) {
      marker.points.push_back(point(corner, z));
    }
    for (const auto& [corner, z] : {std::pair{a, 0.0}, {b, building.height}, {a, building.height}}) {
      marker.points.push_back(point(corner, z));
    }
  }
  colour(marker, 0.6F, 0.6F, 0.6F, 0.8F);
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray world_markers(const SimulatorParameters& world,
                                              const std_msgs::Header& header) {
  visualization_msgs::MarkerArray all;
  for (std::size_t i = 0; i < world.zones.size(); ++i)
    all.markers.push_back(ground(world.zones[i], header, i));
  for (std::size_t i = 0; i < world.buildings.size(); ++i) {
    all.markers.push_back(prism(world.buildings[i], header, i));
  }
  return all;
}

}  // namespace multipath_localization
