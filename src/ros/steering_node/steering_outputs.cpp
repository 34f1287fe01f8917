#include "ros/steering_node/steering_outputs.hpp"

#include <geometry_msgs/Twist.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include "multipath_localization/RouteProgress.h"
#include "multipath_localization/SteeringCommand.h"
#include "multipath_localization/guidance/to_go.hpp"
#include "ros/steering_node/waypoint_markers.hpp"

namespace multipath_localization {

namespace {

constexpr double kBetweenProgress = 1.0;  ///< messages [s]

/// A status without its figures, which change all the time.
std::string kind(const std::string& status) { return status.substr(0, status.find_first_of("0123456789")); }

}  // namespace

SteeringOutputs::SteeringOutputs(ros::NodeHandle node, ros::NodeHandle private_node,
                                 const SteeringNodeParameters& parameters)
    : parameters_(parameters),
      steering_(node.advertise<SteeringCommand>("steering", 10)),
      cmd_vel_(node.advertise<geometry_msgs::Twist>("cmd_vel", 10)),
      status_out_(private_node.advertise<std_msgs::String>("status", 10, true)),
      progress_out_(private_node.advertise<std_msgs::Float64>("progress", 10, true)),
      route_progress_(private_node.advertise<RouteProgress>("route_progress", 10, true)),
      markers_(private_node.advertise<visualization_msgs::MarkerArray>("markers", 1, true)) {
  diagnostics_.setHardwareID("none");
  diagnostics_.add("steering", [this](auto& diagnosis) { diagnose(diagnosis); });
}

void SteeringOutputs::command(const MotionCommand& command, double yaw_rate, const ros::Time& now) {
  SteeringCommand steering;
  steering.header.stamp = now;
  steering.header.frame_id = parameters_.base_link_frame;
  steering.speed = command.speed;
  steering.steering_angle = command.steering_angle;
  steering_.publish(steering);
  geometry_msgs::Twist twist;
  twist.linear.x = command.speed;
  twist.angular.z = yaw_rate;
  cmd_vel_.publish(twist);
}

void SteeringOutputs::say(const std::string& status) {
  if (status == status_) return;
  if (kind(status) != kind(status_)) ROS_INFO_STREAM(status);
  std_msgs::String message;
  message.data = status_ = status;
  status_out_.publish(message);
}

void SteeringOutputs::diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnosis) const {
  using diagnostic_msgs::DiagnosticStatus;
  diagnosis.summary(stands_ || status_ == "driving" ? DiagnosticStatus::OK : DiagnosticStatus::WARN, status_);
  diagnosis.add("progress", progress_);
}

void SteeringOutputs::tell_progress(const WaypointFollower& follower) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if ((now - told_).toSec() < kBetweenProgress) return;
  told_ = now;
  const Route& route = follower.route();
  const ToGo left = to_go(follower, parameters_.follower.cruise_speed);
  RouteProgress message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = parameters_.map_frame;
  message.waypoint = route.empty() ? 0 : static_cast<std::uint32_t>(route.target() + 1);
  message.waypoints = static_cast<std::uint32_t>(route.waypoints().size());
  message.rounds = static_cast<std::uint32_t>(route.rounds());
  message.distance_to_go = left.distance;
  message.time_to_go = left.time;
  route_progress_.publish(message);
}

void SteeringOutputs::report(const std::string& status, const WaypointMission& mission) {
  const WaypointFollower& follower = mission.follower();
  say(status);
  stands_ = mission.stands();
  diagnostics_.update();
  tell_progress(follower);
  const bool laid = follower.progress_on_path() != nullptr;
  if (follower.progress() == progress_ && laid == path_shown_) return;
  path_shown_ = laid;
  std_msgs::Float64 message;
  message.data = progress_ = follower.progress();
  progress_out_.publish(message);
  markers_.publish(waypoint_markers(follower, parameters_.map_frame, parameters_.follower.cruise_speed));
}

}  // namespace multipath_localization
