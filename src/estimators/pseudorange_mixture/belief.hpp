#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization {

/// Where the Kalman filter of a hypothesis keeps what odometry moves. Other states may follow.
enum StateIndex { kX, kY, kYaw, kScale, kGyroBias, kPlanarSize };

/// Gaussian over position [m] and yaw [rad] of the base in map, speed scale [1] and gyro bias [rad/s] of the
/// odometry.
struct Belief {
  using Vector = Eigen::Matrix<double, kPlanarSize, 1>;
  using Matrix = Eigen::Matrix<double, kPlanarSize, kPlanarSize>;

  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Zero();

  [[nodiscard]] Pose2 pose() const { return {mean(kX), mean(kY), mean(kYaw)}; }

  /// Moves on by the odometry summed up since the last call.
  void propagate(const PreintegratedOdometry& odometry, const OdometryNoise& noise);
};

/// Moves mean and covariance P, whose first states are those of StateIndex, by the odometry summed up,
/// without its noise. Returns the rotation from the base at the start of the sum to map.
template <class Vector, class Matrix>
Eigen::Matrix2d move_planar(Vector& mean, Matrix& P, const PreintegratedOdometry& odometry) {
  const Eigen::Matrix2d R = rotation(mean(kYaw));
  const Eigen::Vector2d d = R * odometry.displacement(mean(kScale), mean(kGyroBias));
  // F = I + A on rows (x, y, yaw) and columns (yaw, scale, gyro bias).
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  A.template topRows<2>() << Eigen::Vector2d(-d.y(), d.x()), R * odometry.by_scale(),
      R * odometry.by_gyro_bias();
  A(2, 2) = -odometry.moving_time();
  P.template topRows<3>() += (A * P.template middleRows<3>(kYaw)).eval();
  P.template leftCols<3>() += (P.template middleCols<3>(kYaw) * A.transpose()).eval();
  mean(kYaw) = wrap_angle(mean(kYaw) + odometry.turn(mean(kGyroBias)));
  mean.template head<2>() += d;
  return R;
}

/// Adds the noise of that odometry, turned by the `R` of `move_planar`, and of its slow errors to P.
template <class Matrix>
void add_odometry_noise(Matrix& P, const PreintegratedOdometry& odometry, const Eigen::Matrix2d& R,
                        const OdometryNoise& noise) {
  Eigen::Matrix3d G = Eigen::Matrix3d::Identity();
  G.topLeftCorner<2, 2>() = R;
  P.template topLeftCorner<3, 3>() += G * odometry.covariance() * G.transpose();
  P(kScale, kScale) += noise.scale_walk * noise.scale_walk * odometry.moving_time();
  P(kGyroBias, kGyroBias) += noise.gyro_bias_walk * noise.gyro_bias_walk * odometry.moving_time();
}

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

/// Where an antenna on the base is, by a belief.
struct AntennaPrediction {
  Eigen::Vector2d position;    ///< in map [m]
  Eigen::Matrix2d covariance;  ///< [m^2]

  AntennaPrediction(const Belief& belief, const Eigen::Vector2d& antenna_in_base);
};

}  // namespace multipath_localization
