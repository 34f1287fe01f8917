#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/NavSatFix.h>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

/// What the sensors of a made-up robot send to a running node: odometry in `odom`, and fixes of an antenna at
/// `base_link` with white noise of 0.3 m an axis, which they declare.
class SensorMessages {
 public:
  /// Moves the odometry by the increment. The stamp is the caller's.
  nav_msgs::Odometry odometry(const OdometryIncrement& u, const ros::Time& stamp);
  /// A fix of an antenna at `position` in map [m].
  [[nodiscard]] sensor_msgs::NavSatFix fix(const Eigen::Vector2d& position, const ros::Time& stamp,
                                           RandomStream& random) const;
  /// The base in `odom`.
  [[nodiscard]] const Pose2& base_in_odom() const { return base_in_odom_; }

 private:
  LocalFrame map_{Geodetic{52.5, 13.4, 40.0}};
  Pose2 base_in_odom_;
};

}  // namespace multipath_localization
