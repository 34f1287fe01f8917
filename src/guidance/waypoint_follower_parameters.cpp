#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"

#include <cmath>
#include <map>

namespace multipath_localization {

void WaypointFollowerParameters::fields(ParameterVisitor& field) {
  field("law", law, {"path_tracking", "nishida"},
        "path_tracking: along lines and arcs through the waypoints; nishida: Eqs. (36)-(38) of [NIS]");
  field("cruise_speed", cruise_speed, {0.0, 100.0}, "m/s", "where the localisation is good");
  field("wheelbase", wheelbase, {0.01, 100.0}, "m",
        "front to rear axle; differential: of the steering angle on `steering` alone");
  field("max_steering_angle", max_steering_angle, {0.0, 1.5}, "rad", "front_steering: to either side");
  limits.fields(field);
  field(
      "steering_lag", steering_lag, {0.0, 2.0}, "s",
      "path_tracking: from a commanded steering angle to the base's; bends are steered into so much earlier");
  field("max_lateral_acceleration", max_lateral_acceleration, {1e-3, 1e3}, "m/s^2",
        "path_tracking: bends are driven as slowly as it asks for");
  field("k_phi", k_phi, {0.0, 100.0}, "1", "nishida: gain from heading error to steering angle");
  field("switch_radius", switch_radius, {0.01, 1e3}, "m",
        "a waypoint this near is passed; path_tracking: corners are cut by so much at most");
  field("crossing_width", crossing_width, {0.0, 1e3}, "m",
        "so is one whose line, perpendicular to the way there, is crossed this far aside at most, or within "
        "switch_radius");
  field(
      "loop", loop,
      "after the last waypoint go on to the first, else stop; stop too where none is farther from the first "
      "than 2 (turning radius + switch_radius)");
  field("max_pose_age", max_pose_age, {0.0, 60.0}, "s",
        "a pose older, or as far ahead of now, stops the robot");
  field("max_deviation", max_deviation, {0.0, 1e3}, "m",
        "path_tracking: farther from its path the robot stops; 0: never");
  field("slow_sigma", slow_sigma, {0.0, 1e6}, "m",
        "standard deviation of the position to a side from which on the robot slows, in proportion ...");
  field("stop_sigma", stop_sigma, {0.0, 1e6}, "m", "... and at which it stops");
  field("aligning_distance", aligning_distance, {0.0, 1e3}, "m",
        "in ALIGNING at the start, and after NOT_READY or LOST, go straight this far, for the heading to "
        "show, unless it is confirmed before");
  field("aligning_speed_ratio", aligning_speed_ratio, {0.0, 1.0}, "1",
        "of the cruise speed in ALIGNING, whatever the standard deviation");
}

void WaypointFollowerParameters::refuse_former(const YAML::Node& source, const std::string& path) {
  const std::map<std::string, std::string> instead = {
      {"lookahead",
       "nothing: how soon the robot is back on its path follows from its speed and turning circle"},
      {"multipath_speed_ratio", "slow_sigma and stop_sigma"},
      {"dead_reckoning_speed_ratio", "slow_sigma and stop_sigma"}};
  if (!source.IsMap()) return;
  for (const auto& [key, use] : instead) {
    if (source[key]) throw ParameterError(path + key + " is a parameter no longer; use " + use);
  }
}

double WaypointFollowerParameters::tightest_curvature() const {
  constexpr double kSmallestCircle = 0.2;  // of a differential base, driven: about its own width [m]
  return limits.differential() ? 1.0 / kSmallestCircle : std::tan(max_steering_angle) / wheelbase;
}

double WaypointFollowerParameters::largest_steering_angle() const {
  return limits.differential() ? std::atan(wheelbase * tightest_curvature()) : max_steering_angle;
}

double WaypointFollowerParameters::time_to_lock() const {
  return limits.differential() ? limits.max_yaw_rate / limits.max_yaw_acceleration
                               : max_steering_angle / limits.max_steering_rate;
}

}  // namespace multipath_localization
