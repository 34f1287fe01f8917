#pragma once

#include <geometry_msgs/Quaternion.h>
#include <sensor_msgs/Imu.h>

#include <Eigen/Geometry>
#include <optional>

#include "multipath_localization/core/tilt.hpp"
#include "multipath_localization/localization/gravity_filter.hpp"

namespace multipath_localization {

/// How a base of this yaw [rad] that leans is turned.
geometry_msgs::Quaternion to_orientation(double yaw, const Tilt& tilt);

/// The orientation where the message tells one: its covariance is not -1, and the quaternion of length one.
std::optional<Eigen::Quaterniond> orientation_of(const sensor_msgs::Imu& message);

/// What a message of a sensor that is turned so against the base tells of its tilt; nothing where it tells
/// neither orientation nor acceleration, or its stamp is none. What it declares as unknown (-1) or is not
/// finite counts as not told, and so does an orientation that is level to the bit, as in messages that nobody
/// has filled in.
std::optional<InertialSample> to_inertial(const sensor_msgs::Imu& message,
                                          const Eigen::Quaterniond& imu_in_base);

/// A message of a sensor that is mounted level on a base that leans and turns about the ground's normal: that
/// turn, orientation without yaw, and gravity. The rate is that of the heading.
sensor_msgs::Imu to_message(const YawRate& yaw_rate, const std_msgs::Header& header, const Tilt& tilt);

}  // namespace multipath_localization
