#pragma once

#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <string>
#include <vector>

#include "multipath_localization/guidance/command_limiter.hpp"
#include "multipath_localization/guidance/safety_stop.hpp"
#include "ros/steering_node/moment.hpp"
#include "ros/steering_node/scan_points.hpp"
#include "ros/steering_node/steering_settings.hpp"

namespace multipath_localization {

/// The stop input and the scan: what speaks against driving on.
class SafetyInputs {
 public:
  SafetyInputs(ros::NodeHandle node, const SteeringNodeParameters& parameters);

  /// For a base at `pose` that has carried out the limiter's last command since the scan, and is about to
  /// take `way`, poses from its own on.
  [[nodiscard]] Hazards hazards(const std::vector<Pose2>& way, const CommandLimiter& limiter,
                                const Moment& now) const;

 private:
  void take_stop(bool asked);
  void take_scan(const sensor_msgs::LaserScan& scan);
  [[nodiscard]] std::string fault_of_scan(double age) const;

  SafetyParameters parameters_;
  std::string base_frame_;
  bool stop_asked_ = false;
  ros::SteadyTime stop_arrived_;  ///< zero: never
  ScanPoints scan_;
  Arrival scan_arrival_;
  std::unique_ptr<tf2_ros::Buffer> frames_;
  std::unique_ptr<tf2_ros::TransformListener> tf_;
  ros::Subscriber stop_in_, scan_in_;
};

}  // namespace multipath_localization
