#pragma once

#include <optional>
#include <string>
#include <variant>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

/// What a message of odometry says.
struct OdometryState {
  double stamp = 0.0;  ///< [s]
  Pose2 base_in_odom;
  double speed = 0.0;     ///< over ground [m/s]
  double yaw_rate = 0.0;  ///< [rad/s]
};

/// Where the robot was, with all that it takes to go on from there.
struct SavedPose {
  Geodetic datum;  ///< of the map it is in
  Pose2 base_in_map;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of x, y [m], yaw [rad]
  OdometryState odometry;                                    ///< that the pose belongs to
  bool confirmed = false;                                    ///< the estimator called it aligned
};

/// The pose saved in that file, nothing where there is none. Throws ParameterError where it cannot be read or
/// is damaged; one without the motion of the odometry is.
std::optional<SavedPose> read_saved_pose(const std::string& file);

/// Saves a pose. The file is replaced as a whole. Throws std::system_error and leaves the old file where it
/// cannot.
void write_saved_pose(const std::string& file, const SavedPose& pose);

/// What to start from at this odometry, or the reason why the saved pose does not count: it is older than
/// `max_age` [s] or of a time to come.
///
/// The robot may have come as far as at the faster of its speeds then and now, and turned likewise, with some
/// slack. Where the odometry has moved no further than that, and is further than that from where odometry
/// begins, it has gone on: the pose is rolled on by it and counts as confirmed if it did. Otherwise it may
/// have begun anew, and what it says of the way counts for nothing: the pose is the saved one, to be
/// confirmed anew, less certain by how far the robot may have come. The heading does not tell a beginning: it
/// may be a compass's.
std::variant<PosePrior, std::string> resumed(const SavedPose& saved, const OdometryState& now,
                                             double max_age);

}  // namespace multipath_localization
