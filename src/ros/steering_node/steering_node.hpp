#pragma once

#include <geometry_msgs/PointStamped.h>
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
#include "multipath_localization/guidance/command_limiter.hpp"
#include "multipath_localization/guidance/waypoint_file.hpp"
#include "multipath_localization/guidance/waypoint_mission.hpp"
#include "ros/steering_node/steering_settings.hpp"

namespace multipath_localization {

/// WaypointMission on topics and services: a command leaves with every pose, and a stop when poses cease.
/// When it stands by order, or at the end of the way, stops leave for a second only: others may drive the
/// robot then.
///
/// Waypoints in x and y stay where they are on the ground when map's origin moves. An array of them that
/// comes again restarts nothing: WaypointMission::offer_waypoints.
class SteeringNode {
 public:
  SteeringNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
               const SteeringSettings& settings);

  /// A last command, zero: the one before would hold for ever.
  void halt();

 private:
  void advertise(ros::NodeHandle& node, ros::NodeHandle& private_node);
  void offer_orders(ros::NodeHandle& private_node);
  void offer(ros::NodeHandle& private_node, const std::string& order,
             const std::function<Answer()>& carry_out);
  Answer obey(const std::string& order, const Answer& answer);
  void take_pose(const nav_msgs::Odometry& message);
  /// That the pose is unknown counts at once, even if it is over before the next pose; all else with that.
  void take_state(const LocalizationState& message);
  void take_origin(const geometry_msgs::PoseStamped& message);
  void take_waypoints(const geometry_msgs::PoseArray& message);
  void tell(Delivery delivery, bool resized) const;
  void place_waypoints();
  void take_clicked_point(const geometry_msgs::PointStamped& message);
  Answer stop();
  Answer record_pose();
  Answer record(const Eigen::Vector2d& in_map);
  Answer save();
  void watch();
  void drive();
  /// On to a stand, by what the last pose asked for, with poses or without.
  void brake(const ros::Time& now);
  /// Whether it stands for long enough: zero for ever would fight with who drives by hand.
  bool leaves_to_others();
  /// Since the last command [s]; no stop waits for a clock that stands still.
  double step_to(const ros::Time& now);
  void publish(const MotionCommand& command, const ros::Time& now);
  void report(const std::string& status);
  /// By its stamp, or, where that is longer, since it arrived: a clock that stands still ages nothing. NaN
  /// without a pose.
  [[nodiscard]] double pose_age(const ros::Time& now) const;

  SteeringNodeParameters parameters_;
  WaypointList waypoints_;                 ///< as they were written down
  std::optional<WaypointList> recording_;  ///< these and more, until they are saved
  std::optional<LocalFrame> origin_;       ///< of map, when known
  WaypointMission mission_;
  CommandLimiter limiter_;
  ros::Time commanded_;  ///< when the last command left
  ros::SteadyTime commanded_steady_;
  Pose2 pose_;
  double sigma_ = 0.0;    ///< of the position to a side [m]
  ros::Time pose_stamp_;  ///< zero before the first pose
  ros::SteadyTime pose_arrived_;
  ros::SteadyTime standing_since_;  ///< by order; zero while it is to drive
  bool stopping_ = false;           ///< braking to a stand
  bool urgent_ = false;             ///< that, because the pose must not be driven by
  Trust trust_ = Trust::kNotReady;
  std::string status_;
  double progress_ = -1.0;
  bool path_shown_ = false;  ///< by the markers, not the lines between waypoints

  ros::Publisher steering_, cmd_vel_, status_out_, progress_out_, markers_;
  ros::Subscriber pose_in_, state_in_, origin_in_, waypoints_in_, clicked_point_in_;
  std::vector<ros::ServiceServer> orders_;
  ros::WallTimer watchdog_;
};

}  // namespace multipath_localization
