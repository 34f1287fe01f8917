#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <string>

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/guidance/waypoint_mission.hpp"
#include "ros/steering_node/steering_settings.hpp"

namespace multipath_localization {

/// What steering_node publishes: commands, and what it does along which way.
class SteeringOutputs {
 public:
  SteeringOutputs(ros::NodeHandle node, ros::NodeHandle private_node,
                  const SteeringNodeParameters& parameters);

  /// A command that turns the base at `yaw_rate` [rad/s].
  void command(const MotionCommand& command, double yaw_rate, const ros::Time& now);

  /// What is wanted of a mission, and what becomes of it: the status, when it is another than before, and the
  /// way with the progress on it likewise. Diagnostics have it once a second.
  void report(const std::string& status, const WaypointMission& mission);

  /// The waypoints are others: they are shown with the next report, whatever the progress.
  void show_anew() { progress_ = -1.0; }

 private:
  void say(const std::string& status);
  void tell_progress(const WaypointFollower& follower);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnosis) const;

  SteeringNodeParameters parameters_;
  std::string status_;
  double progress_ = -1.0;
  bool path_shown_ = false;  ///< by the markers, not the lines between waypoints
  bool stands_ = false;      ///< by order, or at the end of the way
  ros::SteadyTime told_;     ///< when the progress was, last
  ros::Publisher steering_, cmd_vel_, status_out_, progress_out_, route_progress_, markers_;
  diagnostic_updater::Updater diagnostics_;
};

}  // namespace multipath_localization
