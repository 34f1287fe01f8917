#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include <string>

#include "models/motion/wheel_odometer.hpp"
#include "ros/inputs/input_monitor.hpp"
#include "ros/wheel_odometry_node/ackermann_message.hpp"
#include "ros/wheel_odometry_node/wheel_odometry_parameters.hpp"

namespace multipath_localization {

/// `joint_states` or `ackermann` in, `odom` out, for a base that has no node of its own for that.
class WheelOdometryNode {
 public:
  /// Throws ParameterError where one is missing.
  WheelOdometryNode(ros::NodeHandle node, const WheelOdometryParameters& parameters);

 private:
  ros::Subscriber subscribed(ros::NodeHandle& node);
  void on_joints(const sensor_msgs::JointState::ConstPtr& message);
  void on_drive(const AckermannDriveStamped::ConstPtr& message);
  /// What has become of a message; `detail` says more of why it is refused.
  void take(const ros::Time& stamp, const WheelMotion& told, const std::string& detail);
  /// That messages come and none names a wheel; empty where one does.
  [[nodiscard]] std::string strangers() const;
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);
  void tell_what_is_wrong();

  WheelOdometryParameters parameters_;
  WheelJoints joints_;
  WheelOdometer odometer_;
  Pose2 base_in_odom_;
  std::string other_joints_;  ///< those of the last message that named no wheel
  ros::Publisher odometry_;
  InputMonitor monitor_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer report_timer_, wrong_timer_;
};

}  // namespace multipath_localization
