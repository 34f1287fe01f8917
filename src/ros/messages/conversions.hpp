#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Transform.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/NavSatFix.h>

#include <optional>
#include <string>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"

/// Messages to the package's vocabulary and, of what sensors say, back; raw measurements are in
/// epoch_conversions.hpp, what estimators say in estimate_messages.hpp. REP-103 (ENU, metres,
/// radians, yaw 0 = east and counter-clockwise) and REP-105 (map -> odom -> base_link) are enforced here and
/// nowhere else.
namespace multipath_localization {

/// A frame's name as tf2 has it, without a leading slash.
std::string without_slash(const std::string& frame);

/// Whether a frame's name is short enough to be looked up, kept and shown: 256 bytes.
bool is_short(const std::string& frame);
/// The name, cut off where it is too long.
std::string shown(const std::string& frame);

/// ros::Time ends soon after, and throws [s]. Its differences throw beyond 2^31 s: take those of toSec().
constexpr double kLatestStamp = 4.1e9;

/// How fixes are read.
struct FixParameters {
  double default_sigma = 3.0;
  double largest_sigma = 1000.0;
  double reach = 100e3;
  int min_fix_status = 0;

  void fields(ParameterVisitor& field);
};

/// A fix, or the reason why it is refused.
struct CheckedFix {
  Reason reason = Reason::kAccepted;
  GnssFix fix;  ///< counts only when accepted
};

/// Reads a fix of an antenna at `antenna_in_base` [m].
///
/// | in the message                                     | what happens                              |
/// |----------------------------------------------------|-------------------------------------------|
/// | stamp zero                                         | refused: zero stamp                       |
/// | status below `min_fix_status` (NO_FIX is -1)       | refused: no fix                           |
/// | latitude, longitude NaN or infinite                | refused: not finite                       |
/// | latitude, longitude out of range, or both zero     | refused: invalid position                 |
/// | further from the datum than `reach`                | refused: invalid position                 |
/// | altitude NaN                                       | accepted: the datum's altitude            |
/// | altitude infinite or beyond 100 km                 | refused: invalid position                 |
/// | covariance type UNKNOWN, whatever the numbers      | `default_sigma` east and north            |
/// | east or north variance zero                        | `default_sigma` east and north            |
/// | any horizontal entry NaN or infinite               | refused: invalid covariance               |
/// | variance negative, or not positive semi-definite   | refused: invalid covariance               |
/// | not symmetric by rounding, 1e-6 of the largest     | accepted: the mean of the two             |
/// | variance above `largest_sigma`^2 (1e308 too)       | refused: invalid covariance               |
/// | type not one of NavSatFix's four                   | refused: invalid covariance               |
/// | type APPROXIMATED or DIAGONAL_KNOWN                | off-diagonal entries are not looked at    |
///
/// Vertical variances are never looked at. Stamps in the future or too old are the Localizer's to refuse.
CheckedFix to_fix(const sensor_msgs::NavSatFix& message, const LocalFrame& map,
                  const FixParameters& parameters,
                  const Eigen::Vector2d& antenna_in_base = Eigen::Vector2d::Zero());

/// The part of `to_fix` that needs no datum: `accepted`, or the reason why not.
Reason check(const sensor_msgs::NavSatFix& message, const FixParameters& parameters);

Geodetic to_geodetic(const sensor_msgs::NavSatFix& message);

/// The way back, at the height of the datum's tangent plane; the vertical variance is twice the horizontal
/// ones together.
sensor_msgs::NavSatFix to_message(const GnssFix& fix, const LocalFrame& map, const std_msgs::Header& header);

/// Two fixes of one instant.
struct FixPair {
  sensor_msgs::NavSatFix left;
  sensor_msgs::NavSatFix right;
};

/// A fix of each of two antennas, or the reason why they are refused.
struct CheckedDual {
  Reason reason = Reason::kAccepted;
  DualAntennaFix fix;  ///< counts only when accepted; its stamp is the later one's
};

/// Reads both as `to_fix` does; the first reason counts, left before right. Antennas less than 1 cm apart are
/// refused as an invalid frame: where tf does not tell them apart, they tell no heading.
CheckedDual to_dual(const FixPair& message, const LocalFrame& map, const FixParameters& parameters,
                    const Eigen::Vector2d& left_antenna_in_base,
                    const Eigen::Vector2d& right_antenna_in_base);

/// Root of the mean horizontal variance as the message declares it [m]; NaN where it declares none.
double declared_sigma(const sensor_msgs::NavSatFix& message);

/// By how much the length of a quaternion may differ from 1, as of one typed in with a digit or two.
inline constexpr double kQuaternionTolerance = 0.03;

/// x and y of a pose in space [m]. Nothing when a coordinate is not finite or over kFurthestPose.
std::optional<Eigen::Vector2d> to_position(const geometry_msgs::Pose& pose);

/// x, y and yaw of a pose in space. A quaternion of four zeros, as drivers leave it that fill in no pose, is
/// no turn. Nothing where to_position says nothing, or the quaternion is not of length one, give or take
/// kQuaternionTolerance.
std::optional<Pose2> to_pose2(const geometry_msgs::Pose& pose);
/// Whether its quaternion is not of four zeros.
bool has_orientation(const geometry_msgs::Pose& pose);
geometry_msgs::Pose to_message(const Pose2& pose);

/// The same numbers.
geometry_msgs::Vector3 to_message(const Eigen::Vector3d& vector);
Eigen::Vector3d vector_of(const geometry_msgs::Vector3& message);

/// A start from a pose with covariance; one of all zeros stands for 0.5 m, 0.5 m and 15 degrees. Nothing when
/// that is no `usable` start, or the quaternion is of four zeros.
std::optional<PosePrior> to_prior(const geometry_msgs::PoseWithCovarianceStamped& message);
/// Why there is no start from it, what of the pose or the covariance cannot be used; empty where there is.
std::string defect_of(const geometry_msgs::PoseWithCovarianceStamped& message);

/// The pose of a child frame in its parent as the transform between them.
geometry_msgs::Transform to_transform(const Pose2& child_in_parent);

/// The odometry with the motion that was read from it as its twist. A twist covariance with an entry that is
/// not finite becomes zero, which stands for unknown.
nav_msgs::Odometry with_motion(nav_msgs::Odometry odometry, const OdometryIncrement& motion);

}  // namespace multipath_localization
