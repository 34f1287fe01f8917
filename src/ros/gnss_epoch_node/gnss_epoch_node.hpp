#pragma once

#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <map>
#include <string>
#include <vector>

#include "ros/messages/drive_messages.hpp"

namespace multipath_localization {

struct GnssEpochNodeParameters {
  std::string drive;
  double rate = 1.0;
  double start = 0.0;
  double delay = 1.0;
  std::string at_end = "exit";
  double loop_pause = 10.0;
  bool publish_clock = false;
  RobotFrames frames;

  void fields(ParameterVisitor& field);
  /// Other than at the recorded pace, time itself is played.
  [[nodiscard]] bool drives_clock() const { return publish_clock || rate != 1.0; }
};

/// Plays a drive directory as the live stream of a robot: raw epochs, fixes, odometry with odom -> base_link,
/// truth where there is one, the antennas and earth -> map on tf.
///
/// Where it drives /clock the stamps are those of the drive, moved on only where ROS would have no such time;
/// else they are moved to now. When the drive is played again, time goes on, after a silence that tells
/// listeners to start afresh.
class GnssEpochNode {
 public:
  /// Throws ParameterError on an unusable parameter, DriveError on a drive that cannot be read.
  GnssEpochNode(const ros::NodeHandle& node, const GnssEpochNodeParameters& parameters);

 private:
  void advertise(ros::NodeHandle& node);
  void tick();
  void publish(const DriveEvent& event);
  void publish_clock(double time);
  void end();
  [[nodiscard]] ros::Time stamp(double time) const { return ros::Time(time + shift_); }

  GnssEpochNodeParameters parameters_;
  Drive drive_;
  std::vector<DriveEvent> events_;  ///< from `start` on
  DriveMessages messages_;
  double shift_ = 0.0;    ///< from times of the drive to stamps [s]
  double time_ = 0.0;     ///< of the drive: all before it is published [s]
  std::size_t next_ = 0;  ///< event
  bool ended_ = false;
  ros::WallTime last_tick_;

  std::map<std::string, ros::Publisher> publishers_;  ///< by topic
  ros::Publisher clock_;
  tf2_ros::TransformBroadcaster transforms_;
  tf2_ros::StaticTransformBroadcaster static_transforms_;
  ros::WallTimer timer_, exit_timer_;
};

}  // namespace multipath_localization
