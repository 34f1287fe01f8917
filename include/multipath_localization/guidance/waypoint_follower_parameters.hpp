#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/guidance/command_limiter.hpp"

namespace multipath_localization {

struct WaypointFollowerParameters {
  std::string law = "path_tracking";
  double cruise_speed = 1.5;
  double wheelbase = 0.5;
  double max_steering_angle = 0.6;
  CommandLimits limits;
  double steering_lag = 0.1;
  double max_lateral_acceleration = 1.0;
  double k_phi = 0.8;
  double switch_radius = 1.0;
  double crossing_width = 5.0;
  bool loop = true;
  double max_pose_age = 0.5;
  double max_deviation = 0.0;
  double slow_sigma = 1.0;
  double stop_sigma = 10.0;
  double aligning_distance = 5.0;
  double aligning_speed_ratio = 0.5;

  void fields(ParameterVisitor& field);

  /// Throws ParameterError on a key that was a parameter once, naming what does its work now; `path` is put
  /// before the key.
  static void refuse_former(const YAML::Node& source, const std::string& path = "");

  /// Whether `law` is that of [NIS], as it is printed.
  [[nodiscard]] bool as_nishida() const { return law == "nishida"; }
  /// That the base can drive [1/m]; a differential one turns on the spot where it is to turn tighter.
  [[nodiscard]] double tightest_curvature() const;
  /// For which a differential base turns as far as `max_steering_angle` does for another [rad].
  [[nodiscard]] double largest_steering_angle() const;
  /// From driving straight to turning as far as it can [s].
  [[nodiscard]] double time_to_lock() const;
};

}  // namespace multipath_localization
