#include "estimators/pseudorange_mixture/belief.hpp"

namespace multipath_localization {

void Belief::propagate(const PreintegratedOdometry& odometry, const OdometryNoise& noise) {
  const Eigen::Matrix2d R = rotation(mean(kYaw));
  const Eigen::Vector2d d = R * odometry.displacement(mean(kScale), mean(kGyroBias));

  // F = I + A on rows (x, y, yaw) and columns (yaw, scale, gyro bias).
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  A.topRows<2>() << Eigen::Vector2d(-d.y(), d.x()), R * odometry.by_scale(), R * odometry.by_gyro_bias();
  A(2, 2) = -odometry.moving_time();
  Matrix& P = covariance;
  P.topRows<3>() += (A * P.middleRows<3>(kYaw)).eval();
  P.leftCols<3>() += (P.middleCols<3>(kYaw) * A.transpose()).eval();
  Eigen::Matrix3d G = Eigen::Matrix3d::Identity();
  G.topLeftCorner<2, 2>() = R;
  P.topLeftCorner<3, 3>() += G * odometry.covariance() * G.transpose();
  P(kScale, kScale) += noise.scale_walk * noise.scale_walk * odometry.moving_time();
  P(kGyroBias, kGyroBias) += noise.gyro_bias_walk * noise.gyro_bias_walk * odometry.moving_time();

  mean(kYaw) = wrap_angle(mean(kYaw) + odometry.turn(mean(kGyroBias)));
  mean.head<2>() += d;
}

FixPrediction::FixPrediction(const Belief& belief, const Eigen::Vector2d& antenna_in_base)
    : antenna(belief.pose() * antenna_in_base), bias(belief.mean.tail<2>()) {
  const Eigen::Vector2d lever = antenna - belief.mean.head<2>();
  const Eigen::Vector2d by_yaw(-lever.y(), lever.x());
  const Belief::Matrix& P = belief.covariance;
  const Eigen::Matrix2d yaw_part = by_yaw * P.block<1, 2>(kYaw, kX);
  antenna_covariance =
      P.topLeftCorner<2, 2>() + yaw_part + yaw_part.transpose() + P(kYaw, kYaw) * by_yaw * by_yaw.transpose();
  bias_covariance = P.bottomRightCorner<2, 2>();
  const Eigen::Matrix2d cross = P.block<2, 2>(kX, kBiasX) + by_yaw * P.block<1, 2>(kYaw, kBiasX);
  cross_covariance = cross + cross.transpose();
}

}  // namespace multipath_localization
