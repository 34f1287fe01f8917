#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What one fix leaves over when odometry is laid on the fixes.
struct Residual {
  double stamp = 0.0;
  Eigen::Vector2d error = Eigen::Vector2d::Zero();  ///< fix less antenna, map [m]
};

/// A stretch of a drive for which odometry was laid on the fixes.
struct StretchFit {
  double duration = 0.0;   ///< [s]
  double way = 0.0;        ///< [m]
  double scale = 1.0;      ///< true speed over that of odometry
  double gyro_bias = 0.0;  ///< of the yaw rate of odometry [rad/s]
  double delay = 0.0;      ///< a fix shows where the antenna was this long before its stamp [s]
  /// Of scale, gyro bias and delay, as if the residuals were white.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  double rms = 0.0;  ///< of one component of the residuals [m]
  std::vector<Residual> residuals;
};

/// Lays the odometry of a stretch on its fixes: least squares by Gauss-Newton over place, heading, scale,
/// gyro bias and delay, with the weights of Huber. Nothing where fixes are few, the robot hardly moved, or
/// odometry does not reach two seconds beyond the fixes.
std::optional<StretchFit> fit_stretch(const std::vector<OdometryIncrement>& increments,
                                      const std::vector<GnssFix>& fixes);

}  // namespace multipath_localization
