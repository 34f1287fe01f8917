#pragma once

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>

#include <optional>
#include <string>

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

  /// Takes waypoints. An array of them that comes again restarts nothing: WaypointMission::offer_waypoints.
  /// Returns whether it changed the mission.
  bool take_waypoints(const geometry_msgs::PoseArray& message);

  /// Records a waypoint in map [m], to be kept by save.
  Answer record(const Eigen::Vector2d& in_map);

  /// Writes what is recorded to the file, and gives it to the mission, which stands then.
  Answer save();

 private:
  void place_waypoints();
  void tell(Delivery delivery, bool resized) const;

  WaypointMission& mission_;
  std::string file_;  ///< empty: none
  std::string map_frame_;
  WaypointList waypoints_;
  std::optional<WaypointList> recording_;  ///< the waypoints and more, until they are saved
  std::optional<LocalFrame> origin_;       ///< of map, when known
};

}  // namespace multipath_localization
