#include "ros/steering_node/route_book.hpp"

#include <ros/console.h>

#include <algorithm>
#include <stdexcept>

#include "multipath_localization/guidance/field_route.hpp"
#include "multipath_localization/guidance/goal_approach.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kSameOrigin = 0.1;       ///< of map: two are one within this [m]
constexpr double kTellRepetition = 60.0;  ///< [s]

Eigen::Vector2d position_of(const geometry_msgs::Pose& pose) { return {pose.position.x, pose.position.y}; }

/// None where the orientation is not filled in, or no rotation.
std::optional<double> heading_of(const geometry_msgs::Pose& pose) {
  const std::optional<Pose2> turned = to_pose2(pose);
  return turned && has_orientation(pose) ? std::optional(turned->yaw) : std::nullopt;
}

}  // namespace

RouteBook::RouteBook(const SteeringSettings& settings, WaypointMission& mission)
    : mission_(mission), parameters_(settings.parameters), waypoints_(settings.waypoints) {
  tasks_.at = waypoints_.tasks;
  place_waypoints();
}

bool RouteBook::take_origin(const geometry_msgs::PoseStamped& message) {
  const Geodetic datum{message.pose.position.y, message.pose.position.x, message.pose.position.z};
  if (without_slash(message.header.frame_id) != parameters_.map_frame || !valid(datum)) {
    ROS_ERROR_STREAM("an origin that is no place on the Earth, or not that of '" << parameters_.map_frame
                                                                                 << "', is refused");
    return false;
  }
  const LocalFrame map(datum);
  const bool first = !origin_;
  if (!first && (map.origin() - origin_->origin()).norm() < kSameOrigin) return false;
  origin_.emplace(map);
  if (!waypoints_.map) waypoints_.map = map;
  if (recording_ && !recording_->map) recording_->map = map;
  if (!first) ROS_WARN_STREAM("the origin of '" << parameters_.map_frame << "' has moved");
  if (first && !waypoints_.on_earth) return false;
  place_waypoints();
  return true;
}

void RouteBook::place_waypoints() {
  if (waypoints_.points.empty()) {
    mission_.stand_without_waypoints(
        parameters_.waypoint_file.empty() ? "no waypoints" : "no waypoints in " + parameters_.waypoint_file);
    return;
  }
  try {
    const std::vector<Eigen::Vector2d> points = to_map(waypoints_, origin_);
    if (waypoints_.field) return place_field(points);
    if (points.size() == mission_.follower().waypoints().size()) {
      mission_.move_waypoints(points);
    } else {
      mission_.set_waypoints(points, tasks_);
    }
  } catch (const std::invalid_argument& reason) {
    mission_.stand_without_waypoints(reason.what());
  }
}

void RouteBook::place_field(const std::vector<Eigen::Vector2d>& border) {
  const FieldTask& field = *waypoints_.field;
  awaits_pose_ = !field.start;
  if (awaits_pose_) {
    mission_.stand_without_waypoints("waiting for the pose, to begin at the nearest corner of the field");
    return;
  }
  const FieldRoute route = field_route(border, field, border[*field.start], parameters_.follower);
  tasks_ = route.tasks;
  if (route.waypoints.size() == mission_.follower().waypoints().size()) {
    mission_.move_waypoints(route.waypoints);
  } else {
    mission_.set_waypoints(route.waypoints, route.tasks);
  }
}

bool RouteBook::take_pose(const Pose2& pose) {
  if (!awaits_pose_ || !waypoints_.field) return false;
  const std::vector<Eigen::Vector2d> border = to_map(waypoints_, origin_);
  const auto nearer = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - pose.position()).norm() < (b - pose.position()).norm();
  };
  const auto nearest = std::min_element(border.begin(), border.end(), nearer);
  waypoints_.field->start = static_cast<std::size_t>(nearest - border.begin());
  place_waypoints();
  return true;
}

bool RouteBook::take_waypoints(const geometry_msgs::PoseArray& message) {
  std::vector<Eigen::Vector2d> points;
  for (const geometry_msgs::Pose& pose : message.poses) points.push_back(position_of(pose));
  return in_map(message.header, "waypoints") && offer(points, {}, message.header.stamp, "waypoints");
}

bool RouteBook::take_plan(const nav_msgs::Path& message) {
  std::vector<Eigen::Vector2d> points;
  for (const geometry_msgs::PoseStamped& pose : message.poses) points.push_back(position_of(pose.pose));
  RouteTasks tasks;
  tasks.once = true;
  if (!message.poses.empty()) tasks.final_heading = heading_of(message.poses.back().pose);
  return in_map(message.header, "a plan") && offer(points, tasks, message.header.stamp, "a plan");
}

bool RouteBook::take_goal(const geometry_msgs::PoseStamped& message, const std::optional<Pose2>& pose) {
  return in_map(message.header, "a goal") && offer_goal(message.pose, pose, message.header.stamp);
}

bool RouteBook::take_goal(const GeoPose& message, const std::optional<Pose2>& pose, const ros::Time& now) {
  geometry_msgs::Pose goal;
  goal.orientation = message.orientation;
  try {
    const Eigen::Vector2d place(message.position.latitude, message.position.longitude);
    const Eigen::Vector2d point = to_map({true, {place}}, origin_).front();
    goal.position.x = point.x();
    goal.position.y = point.y();
  } catch (const std::invalid_argument& error) {
    ROS_ERROR_STREAM("a goal by latitude and longitude is refused: " << error.what());
    return false;
  }
  return offer_goal(goal, pose, now);
}

bool RouteBook::offer_goal(const geometry_msgs::Pose& goal, const std::optional<Pose2>& pose,
                           const ros::Time& stamp) {
  RouteTasks tasks;
  tasks.once = true;
  tasks.final_heading = heading_of(goal);
  const Goal place{position_of(goal), tasks.final_heading};
  return offer(approach(place, pose, parameters_.follower), tasks, stamp, "a goal");
}

bool RouteBook::in_map(const std_msgs::Header& header, const std::string& what) const {
  if (without_slash(header.frame_id) == parameters_.map_frame) return true;
  ROS_ERROR_STREAM(what << " in frame '" << shown(header.frame_id) << "' instead of '"
                        << parameters_.map_frame << "': refused");
  return false;
}

bool RouteBook::offer(const std::vector<Eigen::Vector2d>& points, const RouteTasks& tasks,
                      const ros::Time& stamp, const std::string& what) {
  const WaypointList waypoints{false, points, origin_};
  try {
    const Delivery delivery = mission_.offer_waypoints(to_map(waypoints, origin_), stamp.toNSec(), tasks);
    if (delivery == Delivery::kKnown) return false;
    tell(delivery, waypoints.points.size() != waypoints_.points.size());
    waypoints_ = waypoints;
    tasks_ = tasks;
    return true;
  } catch (const std::invalid_argument& error) {
    ROS_ERROR_STREAM(what << ": refused, as " << error.what());
    return false;
  }
}

void RouteBook::tell(Delivery delivery, bool resized) const {
  const WaypointFollower& follower = mission_.follower();
  const std::string of_all = " of " + std::to_string(follower.waypoints().size());
  if (follower.waypoints().empty()) return;
  if (delivery == Delivery::kNew) {
    ROS_INFO_STREAM("a new route, its waypoints: " << follower.waypoints().size());
  } else if (resized) {
    ROS_INFO_STREAM("the route is continued: next is waypoint " << follower.target() + 1 << of_all);
  } else {
    ROS_INFO_STREAM_THROTTLE(kTellRepetition,
                             "the route came again: next is waypoint " << follower.target() + 1 << of_all);
  }
}

Answer RouteBook::record(const Eigen::Vector2d& in_map) {
  if (parameters_.waypoint_file.empty())
    return {false, "the parameter waypoint_file names no file to save to"};
  WaypointList recording = recording_.value_or(waypoints_);
  try {
    append(recording, in_map, origin_);
  } catch (const std::invalid_argument& reason) {
    return {false, reason.what()};
  }
  recording_ = recording;
  return {true, "waypoint " + std::to_string(recording.points.size()) + ", to be kept by save"};
}

Answer RouteBook::save() {
  if (!recording_) return {false, "nothing is recorded"};
  try {
    const WaypointList recording = moved(*recording_, origin_);
    write_waypoints(parameters_.waypoint_file, recording);
    waypoints_ = recording;
  } catch (const std::exception& reason) {
    return {false, reason.what()};
  }
  mission_.stop();
  tasks_ = {waypoints_.tasks};
  recording_.reset();
  place_waypoints();
  return {true, std::to_string(waypoints_.points.size()) + " waypoints in " + parameters_.waypoint_file +
                    "; start drives along them"};
}

}  // namespace multipath_localization
