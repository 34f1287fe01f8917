#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/Imu.h>

#include <functional>
#include <string>

#include "multipath_localization/localization/gyro_turn.hpp"
#include "ros/inputs/input_monitor.hpp"
#include "ros/messages/imu_conversions.hpp"

namespace multipath_localization {

/// Subscribes to `imu/data` and hands on its yaw rates; tells the console once that they come, and whenever
/// they come to be used or not.
class GyroInput {
 public:
  using Take = std::function<void(const YawRate&)>;

  GyroInput(ros::NodeHandle node, RotationFinder rotation_in_base, Take take);

  /// To be called now and then with what has become of the yaw rates.
  void tell(const GyroTurn& gyro);

  /// How it is by now, in a sentence.
  [[nodiscard]] InputMonitor::Standing standing(const GyroTurn& gyro) const;
  [[nodiscard]] const InputMonitor& monitor() const { return monitor_; }

 private:
  void on_imu(const sensor_msgs::Imu::ConstPtr& message);

  ImuReader reader_;
  Take take_;
  InputMonitor monitor_;
  GyroStanding told_ = GyroStanding::kAbsent;
};

}  // namespace multipath_localization
