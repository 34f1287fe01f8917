#pragma once

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>

#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/GeoPose.h"
#include "multipath_localization/guidance/waypoint_file.hpp"
#include "multipath_localization/guidance/waypoint_mission.hpp"
#include "ros/steering_node/steering_settings.hpp"

namespace multipath_localization {

/// Where to drive: the waypoints as they were written down, those being recorded, and where map is on Earth.
/// A mission gets them in map, as they come and as map's origin moves: those in x and y stay where they are
/// on the ground.
class RouteBook {
 public:
  /// Places the waypoints it is started with into the mission, which has to outlive it.
  RouteBook(const SteeringSettings& settings, WaypointMission& mission);

  /// Takes the origin of map. Returns whether the mission's waypoints are others by it.
  bool take_origin(const geometry_msgs::PoseStamped& message);

  /// Takes where the robot is in map. A field without a corner to begin at begins at the nearest. Returns
  /// whether the mission's waypoints are others by it.
  bool take_pose(const Pose2& pose);

  /// Takes waypoints. An array of them that comes again restarts nothing: WaypointMission::offer_waypoints.
  /// Returns whether it changed the mission.
  bool take_waypoints(const geometry_msgs::PoseArray& message);

  /// Takes a goal, from rviz or whom else, for a robot at `pose` in map where that is known: driven to once.
  /// A quaternion of zeros leaves the heading there open. Returns whether it changed the mission.
  bool take_goal(const geometry_msgs::PoseStamped& message, const std::optional<Pose2>& pose);

  /// The same by latitude and longitude, given at `now`, where map's origin is known.
  bool take_goal(const GeoPose& message, const std::optional<Pose2>& pose, const ros::Time& now);

  /// Takes the path of a planner, likewise.
  bool take_plan(const nav_msgs::Path& message);

  /// Records a waypoint in map [m], to be kept by save.
  Answer record(const Eigen::Vector2d& in_map);

  /// Writes what is recorded to the file, and gives it to the mission, which stands then.
  Answer save();

 private:
  void place_waypoints();
  /// The way over a field within a border in map [m]; nothing, and why, while it waits for the pose.
  void place_field(const std::vector<Eigen::Vector2d>& border);
  /// Offers waypoints in map to the mission; `what` they are is for the log.
  bool offer(const std::vector<Eigen::Vector2d>& points, const RouteTasks& tasks, const ros::Time& stamp,
             const std::string& what);
  bool offer_goal(const geometry_msgs::Pose& goal, const std::optional<Pose2>& pose, const ros::Time& stamp);
  [[nodiscard]] bool in_map(const std_msgs::Header& header, const std::string& what) const;
  void tell(Delivery delivery, bool resized) const;

  WaypointMission& mission_;
  SteeringNodeParameters parameters_;
  WaypointList waypoints_;
  RouteTasks tasks_;                       ///< along them
  std::optional<WaypointList> recording_;  ///< the waypoints and more, until they are saved
  std::optional<LocalFrame> origin_;       ///< of map, when known
  bool awaits_pose_ = false;               ///< to begin a field
};

}  // namespace multipath_localization
