#pragma once

#include <nav_msgs/Odometry.h>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/pose.hpp"
#include "ros/wheel_odometry_node/wheel_odometry_parameters.hpp"

namespace multipath_localization {

/// The odometry of a base that has come to `base_in_odom` by that motion. The pose is dead reckoning, which
/// drifts without bound, and declares a covariance that says so; the twist declares what slip and a wheel's
/// radius cost.
nav_msgs::Odometry to_odometry(const ros::Time& stamp, const OdometryIncrement& motion,
                               const Pose2& base_in_odom, const WheelOdometryParameters& parameters);

}  // namespace multipath_localization
