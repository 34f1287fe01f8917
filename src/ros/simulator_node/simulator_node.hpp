#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <tf2_ros/transform_broadcaster.h>

#include <optional>
#include <string>

#include "multipath_localization/SteeringCommand.h"
#include "ros/simulator_node/simulated_gnss.hpp"
#include "ros/simulator_node/simulated_scan.hpp"
#include "simulation/simulator.hpp"

namespace multipath_localization {

/// Parameters of simulator_node: the world's, and how it is run.
struct SimulatorNodeParameters {
  SimulatorParameters simulator;
  int seed = 1;
  double real_time_factor = 1.0;
  bool publish_clock = false;
  double command_timeout = 0.5;
  RobotFrames frames;
  LaserParameters laser;

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
  void publish_imu(const YawRate& yaw_rate);
  void publish_odometry(const OdometryIncrement& increment);
  void publish_truth();
  [[nodiscard]] ros::Time stamp(double time) const { return origin_ + ros::Duration(time); }

  SimulatorNodeParameters parameters_;
  Simulator simulator_;
  ros::WallTime wall_start_;
  ros::Time origin_;  ///< stamp of simulated time 0
  std::optional<SimulatedGnss> gnss_;
  std::optional<SimulatedScan> scan_;
  MotionCommand command_;
  double command_time_ = 0.0;  ///< simulated, of its arrival
  Pose2 base_in_odom_;

  ros::Publisher odometry_, imu_, truth_, bias_, clock_, markers_;
  ros::Subscriber steering_, cmd_vel_;
  tf2_ros::TransformBroadcaster transforms_;
  ros::WallTimer timer_;
};

}  // namespace multipath_localization
