#include "ros/steering_node/route_book.hpp"

#include <ros/console.h>

#include <stdexcept>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kSameOrigin = 0.1;       ///< of map: two are one within this [m]
constexpr double kTellRepetition = 60.0;  ///< [s]

}  // namespace

RouteBook::RouteBook(const SteeringSettings& settings, WaypointMission& mission)
    : mission_(mission),
      file_(settings.parameters.waypoint_file),
      map_frame_(settings.parameters.map_frame),
      waypoints_(settings.waypoints) {
  place_waypoints();
}

bool RouteBook::take_origin(const geometry_msgs::PoseStamped& message) {
  const Geodetic datum{message.pose.position.y, message.pose.position.x, message.pose.position.z};
  if (without_slash(message.header.frame_id) != map_frame_ || !valid(datum)) {
    ROS_ERROR_STREAM("an origin that is no place on the Earth, or not that of '" << map_frame_
                                                                                 << "', is refused");
    return false;
  }
  const LocalFrame map(datum);
  const bool first = !origin_;
  if (!first && (map.origin() - origin_->origin()).norm() < kSameOrigin) return false;
  origin_.emplace(map);
  if (!waypoints_.map) waypoints_.map = map;
  if (recording_ && !recording_->map) recording_->map = map;
  if (!first) ROS_WARN_STREAM("the origin of '" << map_frame_ << "' has moved");
  if (first && !waypoints_.on_earth) return false;
  place_waypoints();
  return true;
}

void RouteBook::place_waypoints() {
  if (waypoints_.points.empty()) {
    mission_.stand_without_waypoints(file_.empty() ? "no waypoints" : "no waypoints in " + file_);
    return;
  }
  try {
    const std::vector<Eigen::Vector2d> points = to_map(waypoints_, origin_);
    if (points.size() == mission_.follower().waypoints().size()) {
      mission_.move_waypoints(points);
    } else {
      mission_.set_waypoints(points);
    }
  } catch (const std::invalid_argument& reason) {
    mission_.stand_without_waypoints(reason.what());
  }
}

bool RouteBook::take_waypoints(const geometry_msgs::PoseArray& message) {
  if (without_slash(message.header.frame_id) != map_frame_) {
    ROS_ERROR_STREAM("waypoints in frame '" << shown(message.header.frame_id) << "' instead of '"
                                            << map_frame_ << "' are refused");
    return false;
  }
  WaypointList waypoints{false, {}, origin_};
  for (const geometry_msgs::Pose& pose : message.poses)
    waypoints.points.emplace_back(pose.position.x, pose.position.y);
  try {
    const Delivery delivery =
        mission_.offer_waypoints(to_map(waypoints, origin_), message.header.stamp.toNSec());
    if (delivery == Delivery::kKnown) return false;
    tell(delivery, waypoints.points.size() != waypoints_.points.size());
    waypoints_ = waypoints;
    return true;
  } catch (const std::invalid_argument& error) {
    ROS_ERROR_STREAM("waypoints are refused: " << error.what());
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
  if (file_.empty()) return {false, "the parameter waypoint_file names no file to save to"};
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
    write_waypoints(file_, recording);
    waypoints_ = recording;
  } catch (const std::exception& reason) {
    return {false, reason.what()};
  }
  mission_.stop();
  recording_.reset();
  place_waypoints();
  return {true,
          std::to_string(waypoints_.points.size()) + " waypoints in " + file_ + "; start drives along them"};
}

}  // namespace multipath_localization
