#include "ros/steering_node/steering_node.hpp"

#include <cmath>

#include "multipath_localization/guidance/coming_way.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {

SteeringNode::SteeringNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           const SteeringSettings& settings)
    : parameters_(settings.parameters),
      mission_(settings.parameters.follower, {}, settings.parameters.autostart),
      routes_(settings, mission_),
      commands_(settings.parameters.follower),
      outputs_(node, private_node, settings.parameters),
      safety_inputs_(node, settings.parameters),
      safety_(settings.parameters.safety, parameters_.follower.limits.max_deceleration,
              parameters_.follower.limits.braking_delay(parameters_.follower.limits.max_deceleration)) {
  ros::NodeHandle outer(node);
  ros::NodeHandle own(private_node);
  subscribe(outer);
  offer_orders(own);
  watchdog_ = outer.createWallTimer(ros::WallDuration(parameters_.watchdog_period),
                                    [this](const ros::WallTimerEvent&) { watch(); });
}

void SteeringNode::subscribe(ros::NodeHandle& node) {
  inputs_.push_back(node.subscribe<nav_msgs::Odometry>(
      "odometry/filtered_map", 10,
      [this](const nav_msgs::OdometryConstPtr& message) { take_pose(*message); }));
  inputs_.push_back(node.subscribe<LocalizationState>("localization/state", 10,
                                                      [this](const LocalizationStateConstPtr& message) {
                                                        if (pose_.take(*message)) drive();
                                                      }));
  inputs_.push_back(node.subscribe<geometry_msgs::PoseStamped>(
      "local_xy_origin", 1, [this](const geometry_msgs::PoseStampedConstPtr& message) {
        if (routes_.take_origin(*message)) outputs_.show_anew();
      }));
  inputs_.push_back(node.subscribe<geometry_msgs::PoseArray>(
      "waypoints", 1, [this](const geometry_msgs::PoseArrayConstPtr& message) {
        if (routes_.take_waypoints(*message)) drive_anew();
      }));
  inputs_.push_back(node.subscribe<geometry_msgs::PoseStamped>(
      "move_base_simple/goal", 1, [this](const geometry_msgs::PoseStampedConstPtr& message) {
        if (routes_.take_goal(*message, known_pose())) drive_anew();
      }));
  inputs_.push_back(node.subscribe<GeoPose>("geo_goal", 1, [this](const GeoPoseConstPtr& message) {
    if (routes_.take_goal(*message, known_pose(), ros::Time::now())) drive_anew();
  }));
  inputs_.push_back(node.subscribe<nav_msgs::Path>("plan", 1, [this](const nav_msgs::PathConstPtr& message) {
    if (routes_.take_plan(*message)) drive_anew();
  }));
  if (!parameters_.take_clicked_points) return;
  inputs_.push_back(node.subscribe<geometry_msgs::PointStamped>(
      "clicked_point", 10,
      [this](const geometry_msgs::PointStampedConstPtr& message) { take_clicked_point(*message); }));
}

void SteeringNode::take_pose(const nav_msgs::Odometry& message) {
  if (without_slash(message.header.frame_id) != parameters_.map_frame) {
    ROS_WARN_STREAM_THROTTLE(5.0, "pose in frame '" << shown(message.header.frame_id) << "' instead of '"
                                                    << parameters_.map_frame << "' is not driven by");
    return;
  }
  pose_.take(message, ros::SteadyTime::now());
  const std::optional<Pose2> pose = known_pose();
  if (pose && routes_.take_pose(*pose)) outputs_.show_anew();
  drive();
}

bool SteeringNode::pose_is_present() const {
  return std::abs(pose_.age(Moment::now())) <= parameters_.follower.max_pose_age;
}

std::optional<Pose2> SteeringNode::known_pose() const {
  const bool known = pose_is_present() && pose_.known() && pose_.pose().finite();
  return known ? std::optional(pose_.pose()) : std::nullopt;
}

void SteeringNode::watch() {
  if (!pose_is_present()) return drive();
  if (const auto command = commands_.braked(Moment::now())) publish(*command);
}

void SteeringNode::drive_anew() {
  outputs_.show_anew();
  drive();
}

void SteeringNode::drive() {
  const Moment now = Moment::now();
  const double age = pose_.age(now);
  const Pose2 present = commands_.limiter().carried_forward(pose_.pose(), age);
  const FollowerOutput wanted =
      guarded(mission_.command(present, age, pose_.trust(), pose_.sigma(), now.steady.toSec()), present, now);
  outputs_.report(wanted.status, mission_);
  if (const auto command = commands_.towards(wanted, mission_.stands(), now)) publish(*command);
}

FollowerOutput SteeringNode::guarded(const FollowerOutput& wanted, const Pose2& present, const Moment& now) {
  const CommandLimiter& limiter = commands_.limiter();
  const double speed = limiter.last().speed;
  const std::vector<Pose2> way = coming_way(mission_.follower(), parameters_.follower, present,
                                            wanted.command, safety_.look_ahead(speed));
  const FollowerOutput allowed =
      safety_.guarded(wanted, speed, safety_inputs_.hazards(way, limiter, now), now.steady.toSec());
  if (parameters_.safety.resume_by_call && !safety_.reason().empty()) mission_.hold(safety_.reason());
  return allowed;
}

void SteeringNode::halt() { publish(commands_.halted()); }

void SteeringNode::publish(const MotionCommand& command) {
  outputs_.command(command, commands_.limiter().yaw_rate(), ros::Time::now());
}

}  // namespace multipath_localization
