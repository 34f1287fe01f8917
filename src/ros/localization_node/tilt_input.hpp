#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/Imu.h>

#include "multipath_localization/localization/tilt_record.hpp"
#include "ros/inputs/input_monitor.hpp"
#include "ros/messages/imu_conversions.hpp"
#include "ros/messages/tilt_conversions.hpp"

namespace multipath_localization {

/// Subscribes to `imu/data` and keeps the roll and pitch that it tells; tells the console once that they are
/// used, and whenever that changes. A sensor whose frame tf does not know tells none: its mounting would
/// count as a slope.
class TiltInput {
 public:
  /// Without `wanted` the base counts as level.
  TiltInput(ros::NodeHandle node, bool wanted, RotationFinder rotation_in_base);

  /// Takes what the base does; increments in order.
  void drive(const OdometryIncrement& motion);

  /// The tilt of the base at a stamp [s], level where it is not known.
  [[nodiscard]] Tilt at(double stamp) const { return record_.at(stamp); }

  /// The same as of the last increment.
  [[nodiscard]] Tilt now() const { return at(now_); }

  /// To be called now and then.
  void tell();
  /// Whether there is anything to say of it.
  [[nodiscard]] bool seen() const;
  /// How it is by now, in a sentence.
  [[nodiscard]] InputMonitor::Standing standing() const;

 private:
  void on_imu(const sensor_msgs::Imu::ConstPtr& message);

  RotationFinder rotation_in_base_;
  TiltRecord record_;
  double now_ = 0.0;         ///< stamp of the last increment [s]
  bool mounted_ = true;      ///< tf knows the frame of the last message
  bool told_sound_ = false;  ///< as the console was told
  bool told_ = false;        ///< the console, anything
  ros::Subscriber subscriber_;
};

}  // namespace multipath_localization
