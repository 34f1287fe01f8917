#include "estimators/ekf/odometry_state.hpp"

#include <cmath>

#include "multipath_localization/models/fix/gnss_position.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::odometry_state {

namespace {

constexpr double kUnknownYawVariance = kPi * kPi / 3.0;  ///< of a uniform heading [rad^2]

}  // namespace

Pose2 pose(const Vector& state) { return {state(kX), state(kY), wrap_angle(state(kYaw))}; }

OdometerErrors errors(const Vector& state) { return {state(kScale), state(kGyroBias)}; }

Step step(const Vector& state, const OdometryIncrement& u, const OdometryNoise& noise) {
  const MotionJacobians jacobians = motion_jacobians(pose(state), u, errors(state));
  const Pose2 end = moved(pose(state), u, errors(state));
  const Eigen::Matrix2d axes = rotation(state(kYaw));
  const Eigen::Vector2d along = axes.col(0);
  const Eigen::Vector2d across = axes.col(1);
  Step result{state, Matrix::Identity(), Matrix::Zero()};
  result.mean.head<3>() << end.x, end.y, end.yaw;
  result.F.topLeftCorner<3, 3>() = jacobians.pose;
  result.F.topRightCorner<3, 2>() = jacobians.errors;
  result.Q.topLeftCorner<2, 2>() =
      square(noise.distance) * std::abs(u.speed) * u.duration * along * along.transpose() +
      square(noise.distance) * std::abs(u.lateral_speed) * u.duration * across * across.transpose();
  result.Q(kYaw, kYaw) = square(noise.yaw) * u.duration;
  result.Q(kScale, kScale) = square(noise.scale_walk) * u.duration;
  result.Q(kGyroBias, kGyroBias) = square(noise.gyro_bias_walk) * u.duration;
  return result;
}

Eigen::Matrix<double, 2, kSize> antenna_jacobian(const Vector& state,
                                                 const Eigen::Vector2d& antenna_in_base) {
  Eigen::Matrix<double, 2, kSize> H = Eigen::Matrix<double, 2, kSize>::Zero();
  H.leftCols<3>() = multipath_localization::antenna_jacobian(pose(state), antenna_in_base);
  return H;
}

Matrix unknown_covariance(const OdometryNoise& noise) {
  Matrix P = Matrix::Identity();
  P(kYaw, kYaw) = kUnknownYawVariance;
  P(kScale, kScale) = square(noise.scale_sigma);
  P(kGyroBias, kGyroBias) = square(noise.gyro_bias_sigma);
  return P;
}

}  // namespace multipath_localization::odometry_state
