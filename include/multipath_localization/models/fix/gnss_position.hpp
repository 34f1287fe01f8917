#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// Derivative of the antenna's position in map, `pose * antenna_in_base`, to (x, y, yaw).
Eigen::Matrix<double, 2, 3> antenna_jacobian(const Pose2& pose, const Eigen::Vector2d& antenna_in_base);

/// How far a receiver's own statement about its error is believed.
struct DeclaredCovarianceParameters {
  double fix_sigma_floor = 0.3;
  double fix_sigma_cap = 50.0;
  double fix_sigma_unknown = 3.0;

  void fields(ParameterVisitor& field);
};

/// The declared covariance (2x2, see `defect`) with its principal standard deviations held between floor and
/// cap; all zeros mean unknown.
Eigen::Matrix2d believed_covariance(const Eigen::Matrix2d& declared,
                                    const DeclaredCovarianceParameters& parameters);

}  // namespace multipath_localization
