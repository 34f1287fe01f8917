#pragma once

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/LocalizationState.h"
#include "multipath_localization/guidance/waypoint_file.hpp"
#include "multipath_localization/guidance/waypoint_mission.hpp"

namespace multipath_localization {

/// Parameters of steering_node: the follower's, and the names of frames.
struct SteeringNodeParameters {
  WaypointFollowerParameters follower;
  bool autostart = true;
  std::string waypoint_file;
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

/// WaypointMission on topics and services: a command leaves with every pose, and a stop when poses cease.
class SteeringNode {
 public:
  SteeringNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
               const SteeringSettings& settings);

 private:
  void advertise(ros::NodeHandle& node, ros::NodeHandle& private_node);
  void offer_orders(ros::NodeHandle& private_node);
  void offer(ros::NodeHandle& private_node, const std::string& order,
             const std::function<Answer()>& carry_out);
  Answer obey(const std::string& order, const Answer& answer);
  void take_pose(const nav_msgs::Odometry& message);
  void take_origin(const geometry_msgs::PoseStamped& message);
  void take_waypoints(const geometry_msgs::PoseArray& message);
  void place_waypoints();
  void watch();
  void drive();
  void publish(const MotionCommand& command, const ros::Time& now);
  void report(const std::string& status);
  [[nodiscard]] double pose_age(const ros::Time& now) const;

  SteeringNodeParameters parameters_;
  WaypointList waypoints_;            ///< as they were written down
  std::optional<LocalFrame> origin_;  ///< of map, when known
  WaypointMission mission_;
  Pose2 pose_;
  ros::Time pose_stamp_;  ///< zero before the first pose
  Trust trust_ = Trust::kNotReady;
  std::string status_;
  double progress_ = -1.0;

  ros::Publisher steering_, cmd_vel_, status_out_, progress_out_, markers_;
  ros::Subscriber pose_in_, state_in_, origin_in_, waypoints_in_;
  std::vector<ros::ServiceServer> orders_;
  ros::WallTimer watchdog_;
};

}  // namespace multipath_localization
