#pragma once

#include <limits>
#include <string>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/guidance/footprint.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {

/// What halts a robot beside its pose.
struct SafetyParameters {
  bool stop_before_obstacles = false;
  double obstacle_distance = 0.5;
  double max_scan_age = 0.5;
  double max_stop_input_age = 0.0;
  double clear_time = 1.0;
  bool resume_by_call = false;
  Footprint footprint;

  void fields(ParameterVisitor& field);
};

/// What speaks against going on now.
struct Hazards {
  bool stop_asked = false;
  double stop_input_age = std::numeric_limits<double>::infinity();  ///< infinity: it has never spoken [s]
  std::string scan_fault;                                     ///< why no scan can be driven by; or empty
  double free_way = std::numeric_limits<double>::infinity();  ///< before the next obstacle [m]
  bool free_to_turn = true;                                   ///< on the spot
};

/// Halts the robot along its path while the stop input asks for it, before obstacles, and where it is blind.
/// It drives at a speed from which it stops `obstacle_distance` before the next obstacle, and on, once it was
/// halted, when nothing has been in the way for `clear_time`.
class SafetyStop {
 public:
  /// A robot that brakes by `deceleration` [m/s^2], which tells after `braking_delay` [s] in the mean.
  SafetyStop(const SafetyParameters& parameters, double deceleration, double braking_delay = 0.0)
      : parameters_(parameters), deceleration_(deceleration), braking_delay_(braking_delay) {}

  /// What is left of a command in the face of hazards, for a base that drives at `speed` [m/s], at `now` [s]
  /// of a clock that goes on.
  FollowerOutput guarded(const FollowerOutput& wanted, double speed, const Hazards& hazards, double now);

  /// Why the last command was not carried out but the robot halted; empty where it was.
  [[nodiscard]] const std::string& reason() const { return reason_; }

  /// How far ahead to look at that speed [m/s] for obstacles [m].
  [[nodiscard]] double look_ahead(double speed) const;

 private:
  [[nodiscard]] std::string reason_to_halt(const FollowerOutput& wanted, const Hazards& hazards) const;
  [[nodiscard]] FollowerOutput slowed(const FollowerOutput& wanted, double speed, double free_way) const;
  [[nodiscard]] std::string fault_of_inputs(const Hazards& hazards) const;

  SafetyParameters parameters_;
  double deceleration_;
  double braking_delay_;
  std::string reason_;
  double hazard_seen_ = 0.0;  ///< when, where there is a reason [s]
};

}  // namespace multipath_localization
