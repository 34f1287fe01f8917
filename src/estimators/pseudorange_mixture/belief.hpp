#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization {

/// Where the Kalman filter of one hypothesis keeps what.
enum StateIndex { kX, kY, kYaw, kScale, kGyroBias, kBiasX, kBiasY, kStateSize };

/// Gaussian over position [m] and yaw [rad] of the base in map, speed scale [1] and gyro bias [rad/s] of the
/// odometry, and bias of the fix [m].
struct Belief {
  using Vector = Eigen::Matrix<double, kStateSize, 1>;
  using Matrix = Eigen::Matrix<double, kStateSize, kStateSize>;

  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Zero();

  [[nodiscard]] Pose2 pose() const { return {mean(kX), mean(kY), mean(kYaw)}; }

  /// Moves on by the odometry summed up since the last call.
  void propagate(const PreintegratedOdometry& odometry, const OdometryNoise& noise);
};

/// One Gaussian for the mixture with another of `share` (0, 1) of both weights, by its mean and covariance;
/// the element kYaw is an angle.
template <class Vector, class Matrix>
void merge(Vector& mean, Matrix& covariance, const Vector& other_mean, const Matrix& other_covariance,
           double share) {
  Vector d = other_mean - mean;
  d(kYaw) = wrap_angle(d(kYaw));
  covariance *= 1.0 - share;
  covariance += share * other_covariance + (share * (1.0 - share) * d) * d.transpose();
  mean += share * d;
  mean(kYaw) = wrap_angle(mean(kYaw));
}

/// What a belief says of the fix to come: antenna position and bias apart, since modes differ in the bias.
struct FixPrediction {
  Eigen::Vector2d antenna;             ///< in map [m]
  Eigen::Vector2d bias;                ///< [m]
  Eigen::Matrix2d antenna_covariance;  ///< [m^2]
  Eigen::Matrix2d bias_covariance;     ///< [m^2]
  Eigen::Matrix2d cross_covariance;    ///< of antenna and bias plus its transpose [m^2]

  FixPrediction(const Belief& belief, const Eigen::Vector2d& antenna_in_base);
};

}  // namespace multipath_localization
