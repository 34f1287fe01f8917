#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <sensor_msgs/Imu.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"

/// Headings of a compass or of two antennas to the package's vocabulary and back.
namespace multipath_localization {

/// How headings are read.
struct HeadingParameters {
  double default_sigma = 0.1;

  void fields(ParameterVisitor& field);
};

/// A heading, or the reason why it is refused.
struct CheckedHeading {
  Reason reason = Reason::kAccepted;
  Heading heading;  ///< counts only when accepted
};

/// Reads the yaw of an orientation in ENU, counter-clockwise from east, of a sensor that is turned by
/// `in_base` against the base.
///
/// | in the message                                            | what happens                 |
/// |-----------------------------------------------------------|------------------------------|
/// | stamp zero                                                | refused: zero stamp          |
/// | frame's name over 256 bytes                               | refused: invalid frame       |
/// | orientation_covariance[0] is -1: it has no orientation    | refused: unused              |
/// | quaternion NaN, infinite or not of length 1               | refused: invalid orientation |
/// | variance of yaw NaN, infinite or negative                 | refused: invalid covariance  |
/// | variance of yaw zero, as of drivers that do not fill it in | `default_sigma`             |
CheckedHeading to_heading(const sensor_msgs::Imu& message, const HeadingParameters& parameters,
                          const Eigen::Quaterniond& in_base);

/// What of that can be judged without the mounting.
Reason check(const sensor_msgs::Imu& message);

/// Root of the declared variance of yaw [rad]; NaN where none is declared.
double declared_heading_sigma(const sensor_msgs::Imu& message);

/// The orientation of a pose as that of a sensor without a frame, which is the base.
sensor_msgs::Imu orientation_alone(const geometry_msgs::PoseWithCovarianceStamped& message);

/// A message of one of the types that tell a heading, sensor_msgs/Imu or
/// geometry_msgs/PoseWithCovarianceStamped, whose orientation is that of the base; nothing for another. As a
/// topic_tools::ShapeShifter or a rosbag::MessageInstance.
template <class AnyMessage>
std::optional<sensor_msgs::Imu> heading_of(const AnyMessage& message) {
  using Imu = sensor_msgs::Imu;
  using Pose = geometry_msgs::PoseWithCovarianceStamped;
  const std::string type = message.getMD5Sum();
  if (type == ros::message_traits::md5sum<Imu>()) return *message.template instantiate<Imu>();
  if (type != ros::message_traits::md5sum<Pose>()) return std::nullopt;
  return orientation_alone(*message.template instantiate<Pose>());
}

/// A message that tells a heading alone, of a sensor mounted as the base.
sensor_msgs::Imu to_message(const Heading& heading, const std_msgs::Header& header);

}  // namespace multipath_localization
