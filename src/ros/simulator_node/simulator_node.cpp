#include "ros/simulator_node/simulator_node.hpp"

#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>

#include "ros/messages/conversions.hpp"
#include "ros/messages/imu_conversions.hpp"
#include "ros/messages/tilt_conversions.hpp"
#include "ros/simulator_node/world_markers.hpp"

namespace multipath_localization {

namespace {

constexpr double kMaxCatchUp = 0.2;  // of simulated time per tick, where time is ours to slow down [s]

geometry_msgs::TransformStamped transform(const std_msgs::Header& header, const std::string& child,
                                          const Pose2& pose) {
  geometry_msgs::TransformStamped message;
  message.header = header;
  message.child_frame_id = child;
  message.transform.translation.x = pose.x;
  message.transform.translation.y = pose.y;
  message.transform.rotation = to_message(pose).orientation;
  return message;
}

std_msgs::Header header(const ros::Time& stamp, const std::string& frame) {
  std_msgs::Header message;
  message.stamp = stamp;
  message.frame_id = frame;
  return message;
}

}  // namespace

void SimulatorNodeParameters::fields(ParameterVisitor& field) {
  simulator.fields(field);
  field("seed", seed, {0, 2147483647}, "1", "of all random numbers");
  field("real_time_factor", real_time_factor, {0.01, 100.0}, "1",
        "simulated seconds per second; other than 1 the node drives /clock and needs /use_sim_time");
  field("publish_clock", publish_clock, "drive /clock in real time too");
  field("command_timeout", command_timeout, {0.0, 60.0}, "s",
        "without a command for this long the robot stops");
  frames.fields(field);
  field.group("laser", laser, "a scanner of the buildings, all round, on `scan`");
}

SimulatorNode::SimulatorNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                             const SimulatorNodeParameters& parameters)
    : parameters_(parameters), simulator_(parameters.simulator, static_cast<std::uint64_t>(parameters.seed)) {
  if (parameters_.drives_clock() && !ros::Time::isSimTime()) {
    throw ParameterError(
        "real_time_factor and publish_clock need /use_sim_time to be true before any node starts");
  }
  ros::NodeHandle outer(node);
  ros::NodeHandle own(private_node);
  advertise(outer, own);
  wall_start_ = ros::WallTime::now();
  origin_ = ros::Time(wall_start_.sec, wall_start_.nsec);
  scan_.emplace(outer, parameters_.laser, parameters_.simulator.buildings,
                static_cast<std::uint64_t>(parameters_.seed), parameters_.frames.base_link_frame);
  gnss_.emplace(outer, parameters_.simulator, parameters_.frames, origin_);
  markers_.publish(world_markers(parameters_.simulator, header(ros::Time(), parameters_.frames.map_frame)));
  const double period = std::max(simulator_.time_step() / parameters_.real_time_factor, 1e-3);
  timer_ = outer.createWallTimer(ros::WallDuration(period), [this](const ros::WallTimerEvent&) { tick(); });
}

void SimulatorNode::advertise(ros::NodeHandle& node, ros::NodeHandle& private_node) {
  odometry_ = node.advertise<nav_msgs::Odometry>("odom", 200);
  if (parameters_.simulator.gyro.rate > 0.0) imu_ = node.advertise<sensor_msgs::Imu>("imu/data", 200);
  truth_ = node.advertise<nav_msgs::Odometry>("truth", 200);
  bias_ = node.advertise<geometry_msgs::Vector3Stamped>("truth/bias", 200);
  markers_ = private_node.advertise<visualization_msgs::MarkerArray>("markers", 1, true);
  if (parameters_.drives_clock()) clock_ = node.advertise<rosgraph_msgs::Clock>("/clock", 10);
  steering_ = node.subscribe<SteeringCommand>("steering", 10, [this](const SteeringCommandConstPtr& message) {
    take({message->speed, message->steering_angle});
  });
  cmd_vel_ = node.subscribe<geometry_msgs::Twist>(
      "cmd_vel", 10, [this](const geometry_msgs::TwistConstPtr& message) {
        take(motion_command(message->linear.x, message->angular.z, parameters_.simulator.robot.wheelbase));
      });
}

void SimulatorNode::take(const MotionCommand& command) {
  if (!command.finite()) ROS_WARN_THROTTLE(5.0, "a command that is not finite stops the robot");
  command_ = command.finite() ? command : MotionCommand{};
  command_time_ = simulator_.time();
}

void SimulatorNode::tick() {
  const double elapsed = (ros::WallTime::now() - wall_start_).toSec() * parameters_.real_time_factor;
  const double late = elapsed - simulator_.time() - kMaxCatchUp;
  if (parameters_.drives_clock() && late > 0.0) {
    wall_start_ += ros::WallDuration(late / parameters_.real_time_factor);
  }
  const double goal = (ros::WallTime::now() - wall_start_).toSec() * parameters_.real_time_factor;
  while (simulator_.time() + simulator_.time_step() <= goal && ros::ok()) step();
}

void SimulatorNode::step() {
  const bool commanded = simulator_.time() - command_time_ <= parameters_.command_timeout;
  const Readings readings = simulator_.step(commanded ? command_ : MotionCommand{});
  if (parameters_.drives_clock()) {
    rosgraph_msgs::Clock message;
    message.clock = stamp(simulator_.time());
    clock_.publish(message);
  }
  scan_->step(simulator_.truth(), simulator_.time(), stamp(simulator_.time()));
  for (const YawRate& yaw_rate : readings.yaw_rates) {
    publish_imu(yaw_rate);
  }
  if (readings.odometry) {
    publish_odometry(*readings.odometry);
    publish_truth();
  }
  for (const Measurement& measurement : readings.measurements) {
    gnss_->publish(measurement, simulator_.claimed_status(stamp_of(measurement)));
  }
}

void SimulatorNode::publish_imu(const YawRate& yaw_rate) {
  const std_msgs::Header own = header(stamp(yaw_rate.stamp), parameters_.frames.base_link_frame);
  const bool level = parameters_.simulator.ground.slope == 0.0;
  const Tilt tilt = parameters_.simulator.ground.tilt(simulator_.truth());
  imu_.publish(level ? to_message(yaw_rate, own) : to_message(yaw_rate, own, tilt));
}

void SimulatorNode::publish_odometry(const OdometryIncrement& increment) {
  base_in_odom_ = base_in_odom_ * displacement(increment);
  const OdometerParameters& odometer = parameters_.simulator.odometer;
  nav_msgs::Odometry message;
  message.header = header(stamp(increment.stamp), parameters_.frames.odom_frame);
  message.child_frame_id = parameters_.frames.base_link_frame;
  message.pose.pose = to_message(base_in_odom_);
  message.twist.twist.linear.x = increment.speed;
  message.twist.twist.linear.y = increment.lateral_speed;
  message.twist.twist.angular.z = increment.yaw_rate;
  const double speed_sigma = std::hypot(odometer.speed_noise, odometer.speed_noise_ratio * increment.speed);
  for (const std::size_t axis : {0U, 7U, 14U, 21U, 28U, 35U}) {
    message.pose.covariance[axis] = 0.01;
    message.twist.covariance[axis] = 1e-4;
  }
  message.twist.covariance[0] += speed_sigma * speed_sigma;
  message.twist.covariance[35] += odometer.yaw_rate_noise * odometer.yaw_rate_noise;
  odometry_.publish(message);
  transforms_.sendTransform(transform(message.header, message.child_frame_id, base_in_odom_));
}

void SimulatorNode::publish_truth() {
  nav_msgs::Odometry message;
  message.header = header(stamp(simulator_.time()), parameters_.frames.map_frame);
  message.child_frame_id = parameters_.frames.base_link_frame;
  const Tilt tilt = parameters_.simulator.ground.tilt(simulator_.truth());
  message.pose.pose = to_message(simulator_.truth());
  message.pose.pose.orientation = to_orientation(simulator_.truth().yaw, tilt);
  message.twist.twist.linear.x = simulator_.speed();
  message.twist.twist.linear.y = simulator_.lateral_speed();
  message.twist.twist.angular.z = simulator_.yaw_rate();
  truth_.publish(message);
  geometry_msgs::Vector3Stamped bias;
  bias.header = message.header;
  bias.vector.x = simulator_.around().bias.x();
  bias.vector.y = simulator_.around().bias.y();
  bias.vector.z = simulator_.around().in_shadow ? 1.0 : 0.0;
  bias_.publish(bias);
}

}  // namespace multipath_localization
