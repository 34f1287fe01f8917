#pragma once

#include <ros/ros.h>

#include <string>

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"
#include "ros/steering_node/steering_settings.hpp"

namespace multipath_localization {

/// What steering_node publishes: commands, and what it does along which way.
class SteeringOutputs {
 public:
  SteeringOutputs(ros::NodeHandle node, ros::NodeHandle private_node,
                  const SteeringNodeParameters& parameters);

  /// A command that turns the base at `yaw_rate` [rad/s].
  void command(const MotionCommand& command, double yaw_rate, const ros::Time& now);

  /// The status, when it is another than before, and the way with the progress on it likewise.
  void report(const std::string& status, const WaypointFollower& follower);

  /// The waypoints are others: they are shown with the next report, whatever the progress.
  void show_anew() { progress_ = -1.0; }

 private:
  void say(const std::string& status);

  SteeringNodeParameters parameters_;
  std::string status_;
  double progress_ = -1.0;
  bool path_shown_ = false;  ///< by the markers, not the lines between waypoints
  ros::Publisher steering_, cmd_vel_, status_out_, progress_out_, markers_;
};

}  // namespace multipath_localization
