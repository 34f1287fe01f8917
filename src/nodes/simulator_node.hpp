#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <string>

#include "multipath_localization/SteeringCommand.h"
#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/simulation/simulator.hpp"

namespace multipath_localization {

/// Parameters of simulator_node: the world's, and how it is run.
struct SimulatorNodeParameters {
  SimulatorParameters simulator;
  int seed = 1;
  double real_time_factor = 1.0;
  bool publish_clock = false;
  double command_timeout = 0.5;
  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string base_link_frame = "base_link";
  std::string gps_frame = "gps";

  void fields(ParameterVisitor& field);
  /// Other than in real time, time itself is simulated.
  [[nodiscard]] bool drives_clock() const { return publish_clock || real_time_factor != 1.0; }
};

/// Simulator on topics: commands in, what the sensors and the truth have to say out.
class SimulatorNode {
 public:
  /// Throws ParameterError on an unusable parameter.
  SimulatorNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                const SimulatorNodeParameters& parameters);

 private:
  void advertise(ros::NodeHandle& node, ros::NodeHandle& private_node);
  void take(const MotionCommand& command);
  void tick();
  void step();
  void publish_fix(const GnssFix& fix);
  void publish_odometry(const OdometryIncrement& increment);
  void publish_truth();
  void publish_antenna();
  [[nodiscard]] ros::Time stamp(double time) const { return origin_ + ros::Duration(time); }

  SimulatorNodeParameters parameters_;
  Simulator simulator_;
  LocalFrame map_;
  ros::WallTime wall_start_;
  ros::Time origin_;  ///< stamp of simulated time 0
  MotionCommand command_;
  double command_time_ = 0.0;  ///< simulated, of its arrival
  Pose2 base_in_odom_;

  ros::Publisher fix_, odometry_, truth_, bias_, clock_, markers_;
  ros::Subscriber steering_, cmd_vel_;
  tf2_ros::TransformBroadcaster transforms_;
  tf2_ros::StaticTransformBroadcaster static_transforms_;
  ros::WallTimer timer_;
};

}  // namespace multipath_localization
