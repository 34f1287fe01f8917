#include "ros/steering_node/waypoint_markers.hpp"

#include <algorithm>

namespace multipath_localization {

namespace {

using visualization_msgs::Marker;

constexpr double kSize = 1.0;             // [m]
constexpr double kPathStep = 0.2;         // between points of the path, in its arcs too [m]
constexpr double kMostPathPoints = 5000;  // more are farther apart

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

/// Red where the robot is to stand, green at its cruise speed.
std_msgs::ColorRGBA colour_of(double share_of_cruise_speed) {
  std_msgs::ColorRGBA colour;
  colour.r = static_cast<float>(std::min(1.0, 2.0 - 2.0 * share_of_cruise_speed));
  colour.g = static_cast<float>(std::min(1.0, 2.0 * share_of_cruise_speed));
  colour.a = 0.9F;
  return colour;
}

/// The path as it is driven, coloured by the speed planned.
void draw_path(const Path& path, const SpeedProfile& speed, double cruise_speed, Marker& way) {
  const double step = std::max(kPathStep, path.length() / kMostPathPoints);
  const auto add = [&](double s) {
    way.points.push_back(point(path.at(s).position));
    way.colors.push_back(colour_of(cruise_speed > 0.0 ? speed.at(path, s) / cruise_speed : 0.0));
  };
  for (double s = 0.0; s < path.length(); s += step) add(s);
  add(path.length());
}

/// Straight from waypoint to waypoint, where no path is laid yet.
void draw_lines(const std::vector<Eigen::Vector2d>& waypoints, Marker& way) {
  for (const Eigen::Vector2d& waypoint : waypoints) way.points.push_back(point(waypoint));
  way.points.push_back(point(waypoints.front()));
}

}  // namespace

visualization_msgs::MarkerArray waypoint_markers(const WaypointFollower& follower, const std::string& frame,
                                                 double cruise_speed) {
  visualization_msgs::MarkerArray all;
  all.markers.push_back(removed(frame, "waypoints"));
  if (follower.waypoints().empty()) return all;
  Marker spheres = make(frame, "waypoints", Marker::SPHERE_LIST, 0.6 * kSize, 0.1F, 0.5F, 0.9F);
  Marker way = make(frame, "way", Marker::LINE_STRIP, 0.1 * kSize, 0.1F, 0.5F, 0.9F);
  Marker target = make(frame, "target", Marker::SPHERE, 1.2 * kSize, 1.0F, 0.6F, 0.0F);
  target.pose.position = point(follower.waypoints()[follower.target()]);
  for (const Eigen::Vector2d& waypoint : follower.waypoints()) {
    spheres.points.push_back(point(waypoint));
    Marker label = make(frame, "numbers", Marker::TEXT_VIEW_FACING, 1.5 * kSize, 0.1F, 0.3F, 0.6F);
    label.id = static_cast<int>(spheres.points.size());
    label.text = std::to_string(label.id);
    label.pose.position = point(waypoint);
    label.pose.position.z = 1.5 * kSize;
    all.markers.push_back(label);
  }
  if (follower.progress_on_path() != nullptr) {
    draw_path(follower.progress_on_path()->path(), follower.driver()->speed(), cruise_speed, way);
  } else {
    draw_lines(follower.waypoints(), way);
  }
  if (follower.finished()) target.action = Marker::DELETE;
  all.markers.insert(all.markers.end(), {spheres, way, target});
  return all;
}

}  // namespace multipath_localization
