#pragma once

#include <ros/ros.h>

#include <string>
#include <vector>

#include "ros/fault_injector_node/fault_injector.hpp"

namespace multipath_localization {

/// `gps/fix`, `odom`, `imu/data`, `gps/velocity` and `heading` in, the same as `gps/fix_spoiled`,
/// `odom_spoiled`, `imu/data_spoiled`, `gps/velocity_spoiled` and `heading_spoiled` out, and on `~faults`,
/// latched, what is wrong with them now.
class FaultInjectorNode {
 public:
  FaultInjectorNode(ros::NodeHandle node, ros::NodeHandle private_node,
                    const FaultInjectorParameters& parameters);

 private:
  void publish(const std::vector<sensor_msgs::NavSatFix>& fixes);

  FaultInjector injector_;
  std::string told_;  ///< on `~faults`, last
  ros::Publisher fix_out_, odometry_out_, imu_out_, velocity_out_, heading_out_, faults_;
  ros::Subscriber fix_in_, odometry_in_, imu_in_, velocity_in_, heading_in_;
};

}  // namespace multipath_localization
