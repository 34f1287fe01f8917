#pragma once

#include <geometry_msgs/TwistWithCovarianceStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "evaluation/drive.hpp"
#include "multipath_localization/GnssEpoch.h"
#include "ros/messages/robot_frames.hpp"

namespace multipath_localization {

/// One thing that a drive holds and when it came in.
struct DriveEvent {
  double time = 0.0;  ///< on the clock of the stamps [s]
  std::variant<const RecordedYawRate*, const OdometryIncrement*, const RecordedMeasurement*,
               const TruthSample*>
      what;
};

/// All that the drive holds by time, of one time yaw rates first, then odometry, truth last, as `run_drive`
/// takes them. They point into the drive.
std::vector<DriveEvent> events_of(const Drive& drive);

/// A message and the topic it belongs on.
struct TopicMessage {
  std::string topic;  ///< relative: "odom"
  std::variant<nav_msgs::Odometry, sensor_msgs::NavSatFix, GnssEpoch, geometry_msgs::Vector3Stamped,
               sensor_msgs::Imu, geometry_msgs::TwistWithCovarianceStamped>
      message;
};

/// Turns what a drive holds into messages: `odom`, `gps/fix`, `gps_2/fix` and so on, `gps/left/fix` and
/// `gps/right/fix`, `gnss/epoch`, `gps/velocity`, `heading`, `imu/data`, `truth` and where it says so
/// `truth/bias` (z is 1 where fixes are biased).
class DriveMessages {
 public:
  /// The stamp of a time of the drive [s].
  using Clock = std::function<ros::Time(double)>;

  DriveMessages(const Geodetic& datum, const RobotFrames& frames, Clock stamp_of);

  /// Where the antennas of the drive are, and as earth -> map the datum: for `tf_static`.
  [[nodiscard]] tf2_msgs::TFMessage static_transforms(const Drive& drive) const;

  /// What one event becomes. The pose of `odom` sums up the increments given so far, so each has to be given
  /// once and in order.
  std::vector<TopicMessage> of(const DriveEvent& event);

  /// Odometry starts at zero again.
  void restart() { base_in_odom_ = Pose2(); }

 private:
  [[nodiscard]] std_msgs::Header header(double time, const std::string& frame) const;
  [[nodiscard]] TopicMessage of(const OdometryIncrement& increment);
  [[nodiscard]] std::vector<TopicMessage> of(const Measurement& measurement) const;
  [[nodiscard]] std::vector<TopicMessage> of(const TruthSample& truth) const;
  [[nodiscard]] std::vector<geometry_msgs::TransformStamped> antennas_of(
      const Measurement& measurement) const;

  LocalFrame map_;
  RobotFrames frames_;
  Clock stamp_of_;
  Pose2 base_in_odom_;
};

}  // namespace multipath_localization
