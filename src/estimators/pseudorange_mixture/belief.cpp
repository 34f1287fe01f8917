#include "estimators/pseudorange_mixture/belief.hpp"

namespace multipath_localization {

void Belief::propagate(const PreintegratedOdometry& odometry, const OdometryNoise& noise) {
  const Eigen::Matrix2d R = move_planar(mean, covariance, odometry);
  add_odometry_noise(covariance, odometry, R, noise);
}

AntennaPrediction::AntennaPrediction(const Belief& belief, const Eigen::Vector2d& antenna_in_base)
    : position(belief.pose() * antenna_in_base) {
  const Eigen::Vector2d lever = position - belief.mean.head<2>();
  const Eigen::Vector2d by_yaw(-lever.y(), lever.x());
  const Belief::Matrix& P = belief.covariance;
  const Eigen::Matrix2d yaw_part = by_yaw * P.block<1, 2>(kYaw, kX);
  covariance =
      P.topLeftCorner<2, 2>() + yaw_part + yaw_part.transpose() + P(kYaw, kYaw) * by_yaw * by_yaw.transpose();
}

}  // namespace multipath_localization
