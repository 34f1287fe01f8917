#pragma once

#include <tf2_ros/transform_broadcaster.h>

#include <optional>

#include "multipath_localization/core/tilt.hpp"
#include "ros/localization_node/localization_parameters.hpp"

namespace multipath_localization {

/// Broadcasts map -> odom (REP-105) with stamps that only grow: on each odometry message, and in between
/// where odometry is slower than `tf_rate`. Never odom -> base_link, unless asked to.
class MapToOdom {
 public:
  MapToOdom(const FrameParameters& frames, const OutputParameters& outputs);

  /// Sends the correction that belongs to odometry of this pose and stamp, dated `transform_tolerance` ahead,
  /// as far as `max_correction_rate` lets it go. `arrival` is the clock's time.
  void send(const Pose2& odom_in_map, const Pose2& base_in_odom, const ros::Time& stamp,
            const ros::Time& arrival);

  /// The next correction goes all the way at once.
  void jump() { slew_.jump(); }

  /// Shows the rates to a visitor that may change them.
  void tune(ParameterVisitor& field) { slew_.tune(field); }

  /// Sends it again with its stamp moved on by the time since its arrival, unless `tf_rate` is kept anyway or
  /// the odometry has been silent for longer than `longest_silence` [s].
  void keep_up(const ros::Time& now, double longest_silence);

  /// Sends the odometry's own pose, and the tilt, as odom -> base_link.
  void send_odometry(const Pose2& base_in_odom, const Tilt& tilt, const ros::Time& stamp);

  /// Forgets the last correction and its stamp.
  void clear();

 private:
  void broadcast(const ros::Time& stamp);

  FrameParameters frames_;
  OutputParameters outputs_;
  CorrectionSlew slew_;
  tf2_ros::TransformBroadcaster broadcaster_;
  std::optional<Pose2> odom_in_map_;  ///< as broadcast
  ros::Time odometry_stamp_;
  ros::Time arrival_;
  ros::Time last_sent_;  ///< stamp of the last broadcast
  ros::Time last_odometry_sent_;
};

}  // namespace multipath_localization
