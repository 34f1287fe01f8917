#pragma once

#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/TwistWithCovarianceStamped.h>
#include <topic_tools/shape_shifter.h>

#include <optional>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"

/// Velocities of a receiver to the package's vocabulary and back.
namespace multipath_localization {

/// How velocities are read.
struct VelocityParameters {
  double default_sigma = 0.2;
  double max_speed = 150.0;

  void fields(ParameterVisitor& field);
};

/// A velocity, or the reason why it is refused.
struct CheckedVelocity {
  Reason reason = Reason::kAccepted;
  GnssVelocity velocity;  ///< counts only when accepted
};

/// Reads the velocity over ground, x to the east and y to the north, of an antenna at `antenna_in_base` [m].
/// Vertical and angular parts are not looked at.
///
/// | in the message                                      | what happens                |
/// |-----------------------------------------------------|-----------------------------|
/// | stamp zero                                          | refused: zero stamp         |
/// | frame's name over 256 bytes                         | refused: invalid frame      |
/// | east or north NaN or infinite                       | refused: not finite         |
/// | faster than `max_speed`                             | refused: too fast           |
/// | both zero and no variance, as a driver without fix  | refused: repeated           |
/// | variance east or north zero                         | `default_sigma`             |
/// | an entry NaN or infinite, no covariance             | refused: invalid covariance |
CheckedVelocity to_velocity(const geometry_msgs::TwistWithCovarianceStamped& message,
                            const VelocityParameters& parameters,
                            const Eigen::Vector2d& antenna_in_base = Eigen::Vector2d::Zero());

/// `accepted`, or the reason why `to_velocity` refuses it.
Reason check(const geometry_msgs::TwistWithCovarianceStamped& message, const VelocityParameters& parameters);

/// Root of the mean horizontal variance as the message declares it [m/s]; NaN where it declares none.
double declared_sigma(const geometry_msgs::TwistWithCovarianceStamped& message);

/// As drivers publish it that tell no covariance.
geometry_msgs::TwistWithCovarianceStamped without_covariance(const geometry_msgs::TwistStamped& message);

/// The way back; the vertical velocity is zero and as uncertain as twice the horizontal one.
geometry_msgs::TwistWithCovarianceStamped to_message(const GnssVelocity& velocity,
                                                     const std_msgs::Header& header);

/// The velocity in a message of either type that receivers' drivers publish: TwistWithCovarianceStamped or
/// TwistStamped; nothing of another type.
std::optional<geometry_msgs::TwistWithCovarianceStamped> velocity_of(
    const topic_tools::ShapeShifter& message);

}  // namespace multipath_localization
