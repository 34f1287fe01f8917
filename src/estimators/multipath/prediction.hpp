#pragma once

#include "estimators/multipath/hypothesis_cloud.hpp"
#include "estimators/multipath/odometry_sum.hpp"

namespace multipath_localization::multipath {

/// Where the base has got to by odometry, in what it was at the start of the sum.
inline Pose2 moved(const OdometrySum& odometry) {
  return {odometry.displacement().x(), odometry.displacement().y(), odometry.turn()};
}

/// Pose of the base in map and covariance of x, y, yaw [m, rad].
struct Prediction {
  Pose2 pose;
  Eigen::Matrix3d covariance;
};

/// Where the mean of the hypotheses has got to by odometry since they were moved, and how certain that is.
Prediction predicted(const Mixture& mixture, const OdometrySum& odometry);

}  // namespace multipath_localization::multipath
