#include "ros/steering_node/steering_node.hpp"

#include <geometry_msgs/Twist.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "multipath_localization/SteeringCommand.h"
#include "ros/messages/conversions.hpp"
#include "ros/steering_node/waypoint_markers.hpp"

namespace multipath_localization {

namespace {

constexpr double kSayZeroFor = 1.0;  ///< when ordered to stand [s]
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
      mission_(settings.parameters.follower, {}, settings.parameters.autostart),
      limiter_(settings.parameters.follower.limits, settings.parameters.follower.wheelbase) {
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
      "localization/state", 10, [this](const LocalizationStateConstPtr& message) { take_state(*message); });
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
  sigma_ = std::sqrt(0.5 * (message.pose.covariance[0] + message.pose.covariance[7]));
  pose_stamp_ = message.header.stamp;
  pose_arrived_ = ros::SteadyTime::now();
  drive();
}

void SteeringNode::take_state(const LocalizationState& message) {
  const Trust before = std::exchange(trust_, to_trust(message));
  if (trust_ != before && (trust_ == Trust::kNotReady || trust_ == Trust::kLost)) drive();
}

double SteeringNode::pose_age(const ros::Time& now) const {
  if (pose_stamp_.isZero()) return kNaN;
  const double age = now.toSec() - pose_stamp_.toSec();  // a ros::Duration throws beyond 68 years
  const double silence = (ros::SteadyTime::now() - pose_arrived_).toSec();
  return silence > std::abs(age) ? silence : age;
}

void SteeringNode::watch() {
  const double age = pose_age(ros::Time::now());
  if (!(std::abs(age) <= parameters_.follower.max_pose_age)) {
    drive();
  } else if (stopping_) {
    brake(ros::Time::now());
  }
}

void SteeringNode::drive() {
  const ros::Time now = ros::Time::now();
  const double age = pose_age(now);
  const FollowerOutput output = mission_.command(limiter_.carried_forward(pose_, age), age, trust_, sigma_);
  report(output.status);
  urgent_ = output.urgent;
  const bool to_stand = output.command.speed == 0.0 && output.spin == 0.0;
  if (to_stand && !limiter_.at_rest()) return brake(now);
  stopping_ = false;
  const MotionCommand command = limiter_.limited(output.command, urgent_, step_to(now), output.spin);
  if (!leaves_to_others()) publish(command, now);
}

void SteeringNode::brake(const ros::Time& now) {
  const MotionCommand command = limiter_.limited({}, urgent_, step_to(now));
  stopping_ = !limiter_.at_rest();
  publish(command, now);
}

double SteeringNode::step_to(const ros::Time& now) {
  const ros::SteadyTime steady = ros::SteadyTime::now();
  const double silence = (steady - std::exchange(commanded_steady_, steady)).toSec();
  const double step = now.toSec() - std::exchange(commanded_, now).toSec();
  return step > 0.0 ? step : silence;
}

bool SteeringNode::leaves_to_others() {
  if (!mission_.stands()) {
    standing_since_ = {};
    return false;
  }
  if (standing_since_.isZero()) standing_since_ = ros::SteadyTime::now();
  return (ros::SteadyTime::now() - standing_since_).toSec() > kSayZeroFor;
}

void SteeringNode::halt() {
  limiter_.halt();
  publish({}, ros::Time::now());
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
  twist.angular.z = limiter_.yaw_rate();
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
  const bool laid = follower.progress_on_path() != nullptr;
  if (follower.progress() != progress_ || laid != path_shown_) {
    path_shown_ = laid;
    std_msgs::Float64 message;
    message.data = progress_ = follower.progress();
    progress_out_.publish(message);
    markers_.publish(waypoint_markers(follower, parameters_.map_frame, parameters_.follower.cruise_speed));
  }
}

}  // namespace multipath_localization
