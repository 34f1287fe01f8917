#include "estimators/multipath/prediction.hpp"

namespace multipath_localization::multipath {

Prediction predicted(const Mixture& mixture, const OdometrySum& odometry) {
  const Pose2 then = pose_of(mixture.mean);
  const Eigen::Vector2d way = rotation(then.yaw) * odometry.displacement();
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F.topRightCorner<2, 1>() << -way.y(), way.x();
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  turned.topLeftCorner<2, 2>() = rotation(then.yaw);
  const Eigen::Matrix3d noise = odometry.noise().total(mixture.odometry_noise);
  return {then * moved(odometry),
          F * mixture.covariance * F.transpose() + turned * noise * turned.transpose()};
}

}  // namespace multipath_localization::multipath
