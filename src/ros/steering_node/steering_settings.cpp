#include "ros/steering_node/steering_settings.hpp"

namespace multipath_localization {

void SteeringNodeParameters::fields(ParameterVisitor& field) {
  follower.fields(field);
  field.group("safety", safety, "what halts the robot along its path, beside its pose");
  field("autostart", autostart, "drive as soon as the pose allows it, else wait for the service start");
  field("waypoint_file", waypoint_file, {},
        "waypoints in map or by latitude and longitude, by its full path: .csv, .yaml, .geojson, .kml, .gpx, "
        ".plan or .waypoints; empty: none");
  field("take_clicked_points", take_clicked_points, "record the points of rviz's tool Publish Point");
  field("watchdog_period", watchdog_period, {0.001, 10.0}, "s",
        "between looks whether the pose has become too old");
  field("map_frame", map_frame, {}, "of poses and waypoints");
  field("base_link_frame", base_link_frame, {}, "of the robot");
}

SteeringSettings SteeringSettings::from(const YAML::Node& source) {
  SteeringSettings settings;
  YAML::Node parameters = source.IsMap() ? YAML::Clone(source) : YAML::Node();
  if (parameters.IsMap() && parameters["waypoints"]) {
    settings.waypoints.points = load_points(parameters["waypoints"], "waypoints");
    parameters.remove("waypoints");
  }
  WaypointFollowerParameters::refuse_former(parameters);
  load(parameters, settings.parameters);
  const std::string& file = settings.parameters.waypoint_file;
  if (file.empty()) return settings;
  if (!settings.waypoints.points.empty()) {
    throw ParameterError("waypoints and waypoint_file: the robot can be driven by one of them only");
  }
  settings.waypoints = read_waypoints(file).value_or(WaypointList{});
  return settings;
}

}  // namespace multipath_localization
