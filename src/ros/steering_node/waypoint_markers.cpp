#include "ros/steering_node/waypoint_markers.hpp"

namespace multipath_localization {

namespace {

using visualization_msgs::Marker;

constexpr double kSize = 1.0;  // [m]

geometry_msgs::Point point(const Eigen::Vector2d& position) {
  geometry_msgs::Point message;
  message.x = position.x();
  message.y = position.y();
  return message;
}

Marker make(const std::string& frame, const std::string& ns, int type, double size, float r, float g,
            float b) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = ns;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = size;
  marker.color.r = r;
  marker.color.g = g;
  marker.color.b = b;
  marker.color.a = 0.9F;
  return marker;
}

Marker removed(const std::string& frame, const std::string& ns) {
  Marker marker = make(frame, ns, Marker::SPHERE, kSize, 0.0F, 0.0F, 0.0F);
  marker.action = Marker::DELETEALL;
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray waypoint_markers(const WaypointFollower& follower, const std::string& frame) {
  visualization_msgs::MarkerArray all;
  all.markers.push_back(removed(frame, "waypoints"));
  if (follower.waypoints().empty()) return all;
  Marker spheres = make(frame, "waypoints", Marker::SPHERE_LIST, 0.6 * kSize, 0.1F, 0.5F, 0.9F);
  Marker way = make(frame, "way", Marker::LINE_STRIP, 0.1 * kSize, 0.1F, 0.5F, 0.9F);
  Marker target = make(frame, "target", Marker::SPHERE, 1.2 * kSize, 1.0F, 0.6F, 0.0F);
  target.pose.position = point(follower.waypoints()[follower.target()]);
  for (const Eigen::Vector2d& waypoint : follower.waypoints()) {
    spheres.points.push_back(point(waypoint));
    way.points.push_back(point(waypoint));
    Marker label = make(frame, "numbers", Marker::TEXT_VIEW_FACING, 1.5 * kSize, 0.1F, 0.3F, 0.6F);
    label.id = static_cast<int>(spheres.points.size());
    label.text = std::to_string(label.id);
    label.pose.position = point(waypoint);
    label.pose.position.z = 1.5 * kSize;
    all.markers.push_back(label);
  }
  way.points.push_back(point(follower.waypoints().front()));
  if (follower.finished()) target.action = Marker::DELETE;
  all.markers.insert(all.markers.end(), {spheres, way, target});
  return all;
}

}  // namespace multipath_localization
