#pragma once

#include <string>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/guidance/safety_stop.hpp"
#include "multipath_localization/guidance/waypoint_file.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {

/// Parameters of steering_node: the follower's, what halts the robot, and the names of frames.
struct SteeringNodeParameters {
  WaypointFollowerParameters follower;
  SafetyParameters safety;
  bool autostart = true;
  std::string waypoint_file;
  bool take_clicked_points = false;
  double watchdog_period = 0.1;
  std::string map_frame = "map";
  std::string base_link_frame = "base_link";

  void fields(ParameterVisitor& field);
};

/// What a node was started with.
struct SteeringSettings {
  SteeringNodeParameters parameters;
  WaypointList waypoints;

  /// `source` holds SteeringNodeParameters and `waypoints: [[x, y], ...]`, in map [m], or a `waypoint_file`.
  /// Throws ParameterError on anything unknown or unusable.
  static SteeringSettings from(const YAML::Node& source);
};

}  // namespace multipath_localization
