// Where to drive: waypoints as they come, and as map's origin moves.

#include <stdexcept>

#include "ros/messages/conversions.hpp"
#include "ros/steering_node/steering_node.hpp"

namespace multipath_localization {

namespace {

constexpr double kSameOrigin = 0.1;       ///< of map: two are one within this [m]
constexpr double kTellRepetition = 60.0;  ///< [s]

}  // namespace

void SteeringNode::take_origin(const geometry_msgs::PoseStamped& message) {
  const Geodetic datum{message.pose.position.y, message.pose.position.x, message.pose.position.z};
  if (without_slash(message.header.frame_id) != parameters_.map_frame || !valid(datum)) {
    ROS_ERROR_STREAM("an origin that is no place on the Earth, or not that of '" << parameters_.map_frame
                                                                                 << "', is refused");
    return;
  }
  const LocalFrame map(datum);
  const bool first = !origin_;
  if (!first && (map.origin() - origin_->origin()).norm() < kSameOrigin) return;
  origin_.emplace(map);
  if (!waypoints_.map) waypoints_.map = map;
  if (recording_ && !recording_->map) recording_->map = map;
  if (!first) ROS_WARN_STREAM("the origin of '" << parameters_.map_frame << "' has moved");
  if (!first || waypoints_.on_earth) place_waypoints();
}

void SteeringNode::place_waypoints() {
  const std::string& file = parameters_.waypoint_file;
  progress_ = -1.0;
  if (waypoints_.points.empty()) {
    mission_.stand_without_waypoints(file.empty() ? "no waypoints" : "no waypoints in " + file);
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

void SteeringNode::take_waypoints(const geometry_msgs::PoseArray& message) {
  if (without_slash(message.header.frame_id) != parameters_.map_frame) {
    ROS_ERROR_STREAM("waypoints in frame '" << shown(message.header.frame_id) << "' instead of '"
                                            << parameters_.map_frame << "' are refused");
    return;
  }
  WaypointList waypoints{false, {}, origin_};
  for (const geometry_msgs::Pose& pose : message.poses)
    waypoints.points.emplace_back(pose.position.x, pose.position.y);
  try {
    const Delivery delivery =
        mission_.offer_waypoints(to_map(waypoints, origin_), message.header.stamp.toNSec());
    if (delivery == Delivery::kKnown) return;
    tell(delivery, waypoints.points.size() != waypoints_.points.size());
    waypoints_ = waypoints;
    progress_ = -1.0;
    drive();
  } catch (const std::invalid_argument& error) {
    ROS_ERROR_STREAM("waypoints are refused: " << error.what());
  }
}

void SteeringNode::tell(Delivery delivery, bool resized) const {
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

}  // namespace multipath_localization
