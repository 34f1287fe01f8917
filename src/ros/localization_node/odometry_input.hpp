#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>

#include "ros/inputs/input_monitor.hpp"
#include "ros/inputs/odometry_reader.hpp"
#include "ros/localization_node/backlog.hpp"

namespace multipath_localization {

/// Subscribes to `odom`, reads what comes, and holds it on its way to the estimator.
class OdometryInput {
 public:
  using Take = std::function<void(const nav_msgs::Odometry&)>;
  OdometryInput(ros::NodeHandle node, const OdometryParameters& parameters, const std::string& map_frame,
                Take take);

  /// Reads a message that has come, and tells the console where many are refused.
  CheckedOdometry read(const nav_msgs::Odometry& message);
  /// Forgets the messages before: the next one is a first one.
  void clear() { reader_.clear(); }

  [[nodiscard]] HeldOdometry& held() { return held_; }
  [[nodiscard]] const InputMonitor& monitor() const { return monitor_; }

 private:
  void on_odometry(const nav_msgs::Odometry::ConstPtr& message) { take_(*message); }

  OdometryReader reader_;
  HeldOdometry held_;
  Take take_;
  InputMonitor monitor_;
};

}  // namespace multipath_localization
