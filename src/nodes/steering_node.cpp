#include "nodes/steering_node.hpp"

#include <geometry_msgs/Twist.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <stdexcept>

#include "multipath_localization/SteeringCommand.h"
#include "nodes/conversions.hpp"
#include "nodes/waypoint_markers.hpp"

namespace multipath_localization {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// What is not one of the known states is not to be driven by.
Trust to_trust(const LocalizationState& message) {
  return message.state <= LocalizationState::LOST ? static_cast<Trust>(message.state) : Trust::kLost;
}

/// A status without its figures, which change all the time.
std::string kind(const std::string& status) { return status.substr(0, status.find_first_of("0123456789")); }

}  // namespace

SteeringNode::SteeringNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           const SteeringSettings& settings)
    : parameters_(settings.parameters),
      waypoints_(settings.waypoints),
      mission_(settings.parameters.follower, {}, settings.parameters.autostart) {
  ros::NodeHandle outer(node);
  ros::NodeHandle own(private_node);
  place_waypoints();
  advertise(outer, own);
  offer_orders(own);
  watchdog_ = outer.createWallTimer(ros::WallDuration(parameters_.watchdog_period),
                                    [this](const ros::WallTimerEvent&) { watch(); });
}

void SteeringNode::advertise(ros::NodeHandle& node, ros::NodeHandle& private_node) {
  steering_ = node.advertise<SteeringCommand>("steering", 10);
  cmd_vel_ = node.advertise<geometry_msgs::Twist>("cmd_vel", 10);
  status_out_ = private_node.advertise<std_msgs::String>("status", 10, true);
  progress_out_ = private_node.advertise<std_msgs::Float64>("progress", 10, true);
  markers_ = private_node.advertise<visualization_msgs::MarkerArray>("markers", 1, true);
  pose_in_ = node.subscribe<nav_msgs::Odometry>(
      "odometry/filtered_map", 10,
      [this](const nav_msgs::OdometryConstPtr& message) { take_pose(*message); });
  state_in_ = node.subscribe<LocalizationState>(
      "localization/state", 10,
      [this](const LocalizationStateConstPtr& message) { trust_ = to_trust(*message); });
  origin_in_ = node.subscribe<geometry_msgs::PoseStamped>(
      "local_xy_origin", 1,
      [this](const geometry_msgs::PoseStampedConstPtr& message) { take_origin(*message); });
  waypoints_in_ = node.subscribe<geometry_msgs::PoseArray>(
      "waypoints", 1, [this](const geometry_msgs::PoseArrayConstPtr& message) { take_waypoints(*message); });
  if (!parameters_.take_clicked_points) return;
  clicked_point_in_ = node.subscribe<geometry_msgs::PointStamped>(
      "clicked_point", 10,
      [this](const geometry_msgs::PointStampedConstPtr& message) { take_clicked_point(*message); });
}

void SteeringNode::take_pose(const nav_msgs::Odometry& message) {
  if (without_slash(message.header.frame_id) != parameters_.map_frame) {
    ROS_WARN_STREAM_THROTTLE(5.0, "pose in frame '" << shown(message.header.frame_id) << "' instead of '"
                                                    << parameters_.map_frame << "' is not driven by");
    return;
  }
  pose_ = to_pose2(message.pose.pose).value_or(Pose2{kNaN, kNaN, kNaN});
  pose_stamp_ = message.header.stamp;
  pose_arrived_ = ros::WallTime::now();
  drive();
}

void SteeringNode::take_origin(const geometry_msgs::PoseStamped& message) {
  const Geodetic datum{message.pose.position.y, message.pose.position.x, message.pose.position.z};
  if (without_slash(message.header.frame_id) != parameters_.map_frame || !valid(datum)) {
    ROS_ERROR_STREAM("an origin that is no place on the Earth, or not that of '" << parameters_.map_frame
                                                                                 << "', is refused");
    return;
  }
  origin_.emplace(datum);
  if (waypoints_.on_earth) place_waypoints();
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
  WaypointList waypoints;
  for (const geometry_msgs::Pose& pose : message.poses)
    waypoints.points.emplace_back(pose.position.x, pose.position.y);
  try {
    mission_.set_waypoints(to_map(waypoints, origin_));
    waypoints_ = waypoints;
    progress_ = -1.0;
  } catch (const std::invalid_argument& error) {
    ROS_ERROR_STREAM("waypoints are refused: " << error.what());
  }
}

double SteeringNode::pose_age(const ros::Time& now) const {
  if (pose_stamp_.isZero()) return kNaN;
  const double age = (now - pose_stamp_).toSec();
  const double silence = (ros::WallTime::now() - pose_arrived_).toSec();
  return silence > std::abs(age) ? silence : age;
}

void SteeringNode::watch() {
  const double age = pose_age(ros::Time::now());
  if (!(std::abs(age) <= parameters_.follower.max_pose_age)) drive();
}

void SteeringNode::drive() {
  const ros::Time now = ros::Time::now();
  const FollowerOutput output = mission_.command(pose_, pose_age(now), trust_);
  publish(output.command, now);
  report(output.status);
}

void SteeringNode::publish(const MotionCommand& command, const ros::Time& now) {
  SteeringCommand steering;
  steering.header.stamp = now;
  steering.header.frame_id = parameters_.base_link_frame;
  steering.speed = command.speed;
  steering.steering_angle = command.steering_angle;
  steering_.publish(steering);
  geometry_msgs::Twist twist;
  twist.linear.x = command.speed;
  twist.angular.z = yaw_rate(command, parameters_.follower.wheelbase);
  cmd_vel_.publish(twist);
}

void SteeringNode::report(const std::string& status) {
  if (status != status_) {
    if (kind(status) != kind(status_)) ROS_INFO_STREAM(status);
    std_msgs::String message;
    message.data = status_ = status;
    status_out_.publish(message);
  }
  const WaypointFollower& follower = mission_.follower();
  if (follower.progress() != progress_) {
    std_msgs::Float64 message;
    message.data = progress_ = follower.progress();
    progress_out_.publish(message);
    markers_.publish(waypoint_markers(follower, parameters_.map_frame));
  }
}

}  // namespace multipath_localization
