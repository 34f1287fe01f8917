#pragma once

#include <optional>
#include <string>
#include <variant>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

/// Where the robot was, with all that it takes to go on from there.
struct SavedPose {
  Geodetic datum;      ///< of the map it is in
  double stamp = 0.0;  ///< of the odometry it belongs to [s]
  Pose2 base_in_map;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of x, y [m], yaw [rad]
  Pose2 base_in_odom;
  bool confirmed = false;  ///< the estimator called it aligned
};

/// The pose saved in that file, nothing where there is none. Throws ParameterError where it cannot be read or
/// is damaged.
std::optional<SavedPose> read_saved_pose(const std::string& file);

/// Saves a pose. The file is replaced as a whole. Throws std::system_error and leaves the old file where it
/// cannot.
void write_saved_pose(const std::string& file, const SavedPose& pose);

/// What to start from now that the odometry, of stamp `stamp` [s], has the base at `base_in_odom`: the robot
/// may have rolled on meanwhile by that odometry. Where it cannot have come that far the odometry has begun
/// anew; then the pose is the saved one, and to be confirmed again. Otherwise the reason why the saved pose
/// does not count: it is older than `max_age` [s] or of a time to come.
std::variant<PosePrior, std::string> resumed(const SavedPose& saved, double stamp, const Pose2& base_in_odom,
                                             double max_age);

}  // namespace multipath_localization
