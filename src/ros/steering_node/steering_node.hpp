#pragma once

#include <geometry_msgs/PointStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/LocalizationState.h"
#include "multipath_localization/guidance/safety_stop.hpp"
#include "multipath_localization/guidance/waypoint_mission.hpp"
#include "ros/steering_node/command_stream.hpp"
#include "ros/steering_node/pose_input.hpp"
#include "ros/steering_node/route_book.hpp"
#include "ros/steering_node/safety_inputs.hpp"
#include "ros/steering_node/steering_outputs.hpp"
#include "ros/steering_node/steering_settings.hpp"

namespace multipath_localization {

/// WaypointMission on topics and services: a command leaves with every pose, and a stop when poses cease.
class SteeringNode {
 public:
  SteeringNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
               const SteeringSettings& settings);

  /// A last command, zero: the one before would hold for ever.
  void halt();

 private:
  void subscribe(ros::NodeHandle& node);
  void offer_orders(ros::NodeHandle& private_node);
  void offer(ros::NodeHandle& private_node, const std::string& order,
             const std::function<Answer()>& carry_out);
  Answer obey(const std::string& order, const Answer& answer);
  void take_pose(const nav_msgs::Odometry& message);
  void take_clicked_point(const geometry_msgs::PointStamped& message);
  Answer stop();
  Answer record_pose();
  Answer save();
  [[nodiscard]] bool pose_is_present() const;
  [[nodiscard]] std::optional<Pose2> known_pose() const;
  void watch();
  void drive_anew();  ///< along other waypoints
  void drive();
  /// What is left of a command in the face of what is in the way.
  FollowerOutput guarded(const FollowerOutput& wanted, const Pose2& present, const Moment& now);
  void publish(const MotionCommand& command);

  SteeringNodeParameters parameters_;
  WaypointMission mission_;
  RouteBook routes_;
  PoseInput pose_;
  CommandStream commands_;
  SteeringOutputs outputs_;
  SafetyInputs safety_inputs_;
  SafetyStop safety_;
  std::vector<ros::Subscriber> inputs_;
  std::vector<ros::ServiceServer> orders_;
  ros::WallTimer watchdog_;
};

}  // namespace multipath_localization
