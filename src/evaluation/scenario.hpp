#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"
#include "simulation/simulator.hpp"

namespace multipath_localization {

/// One piece of a sequence of commands.
struct SequenceLeg {
  double duration = 1.0;
  double speed = 0.0;
  double yaw_rate = 0.0;

  void fields(ParameterVisitor& field);
};

/// The command at a time [s] after the start, for a robot of that wheelbase [m]; after the last leg a stop. A
/// leg that stands does not turn either.
MotionCommand command_at(const std::vector<SequenceLeg>& sequence, double time, double wheelbase);

/// A ready run: what is simulated, how it is driven, for how long, and what the estimators are told of it.
/// Its top-level keys are the names of the nodes, so that roslaunch loads the same file into a namespace.
struct Scenario {
  std::string name;  ///< of the file, without extension
  SimulatorParameters simulator;
  WaypointFollowerParameters steering;
  std::vector<Eigen::Vector2d> waypoints;  ///< in map [m]
  std::vector<SequenceLeg> sequence;       ///< instead of steering, unless empty
  double duration = 60.0;                  ///< [s]
  bool steered_on_truth = false;           ///< by a driver who sees the way, not on the estimate
  YAML::Node localization;                 ///< parameters by estimator name; null for none
};

/// Reads a scenario. Throws ParameterError when it cannot be read or holds what nobody reads.
Scenario load_scenario(const std::string& file);

/// The same from what such a file holds; `origin` is where it comes from, for what is said of it.
Scenario parse_scenario(const YAML::Node& source, const std::string& name, const std::string& origin);

}  // namespace multipath_localization
