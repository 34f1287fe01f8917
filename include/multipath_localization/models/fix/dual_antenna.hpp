#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// What two antennas on one base tell of its pose.
struct DualAntennaPose {
  Eigen::Vector3d pose = Eigen::Vector3d::Zero();            ///< base in map: x, y, yaw in (-pi, pi] [m, rad]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< [m, rad]
  double baseline_error = 0.0;  ///< distance seen between the antennas - the one they are mounted at [m]
  double baseline_nis = 0.0;    ///< that squared over its variance, 1 dof
};

/// The pose z of Eq. (5) of [KAM] from two fixes: the heading turns the line between the lever arms on to the
/// line between the positions, in the ordinary mounting the normal of the baseline, Fig. 1; the lever arms
/// lead from the antennas to the base. The errors of the two fixes are taken as independent, each with its
/// declared covariance.
///
/// Two fixes are one number more than a pose has: the distance between the antennas, known from the mounting
/// to `baseline_tolerance` [m] (1 sigma). Where one fix is better than the other it moves the pose towards
/// what the better one says, and it shows an antenna that is off. Nothing when no heading can be told: the
/// antennas are mounted within a centimetre or were seen at one point.
std::optional<DualAntennaPose> dual_antenna_pose(const DualAntennaFix& fixes, double baseline_tolerance);

/// Error of a pose from two antennas, as measured in section 3.3 of [KAM] at a baseline of 0.3 m: of x, y in
/// map and yaw.
struct PoseErrorParameters {
  std::vector<double> mean = {0.0523096875, -0.0315079375, -0.0287904375};  ///< Eq. (11)
  std::vector<double> covariance = {
      0.0000041093, -0.0000001684, -0.0000053749, -0.0000001684, 0.0000058535,
      0.0000322863, -0.0000053749, 0.0000322863,  0.0003444646};  ///< Eq. (12), row by row

  void fields(ParameterVisitor& field);
};

/// The same as a distribution.
struct PoseError {
  /// Throws ParameterError unless there are three means and nine entries of a symmetric positive
  /// semi-definite matrix.
  explicit PoseError(const PoseErrorParameters& parameters);

  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
  Eigen::Matrix3d root;  ///< root * root' = covariance
};

}  // namespace multipath_localization
