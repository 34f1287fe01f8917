#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

#include <cmath>

#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization {

void OdometryNoise::fields(ParameterVisitor& field) {
  field("distance", distance, {1e-6, 1.0}, "m/sqrt(m)",
        "noise of the distance travelled, per root of a metre");
  field("yaw", yaw, {1e-6, 1.0}, "rad/sqrt(s)", "noise of the heading while moving, per root of a second");
  field("scale_sigma", scale_sigma, {0.0, 0.5}, "1", "1 sigma of the unknown speed scale error at start");
  field("gyro_bias_sigma", gyro_bias_sigma, {0.0, 0.5}, "rad/s",
        "1 sigma of the unknown yaw rate bias at start");
  field("scale_walk", scale_walk, {0.0, 0.1}, "1/sqrt(s)", "random walk of the speed scale while moving");
  field("gyro_bias_walk", gyro_bias_walk, {0.0, 0.1}, "rad/s/sqrt(s)",
        "random walk of the yaw rate bias while moving");
}

void PreintegratedOdometry::restart(double scale, double gyro_bias) {
  *this = PreintegratedOdometry(noise_);
  scale_ = scale;
  gyro_bias_ = gyro_bias;
}

void PreintegratedOdometry::add(const OdometryIncrement& increment) {
  const double dt = increment.duration;
  duration_ += dt;
  if (standing(increment)) return;

  const double distance = increment.speed / (1.0 + scale_) * dt;
  const double sideways = increment.lateral_speed / (1.0 + scale_) * dt;
  const double turn = (increment.yaw_rate - gyro_bias_) * dt;
  const double heading = turn_ + 0.5 * turn;
  const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
  const Eigen::Vector2d across(-along.y(), along.x());

  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  const Eigen::Vector2d way = distance * along + sideways * across;
  const Eigen::Vector2d turned_way = distance * across - sideways * along;
  F.topRightCorner<2, 1>() = turned_way;
  covariance_ = F * covariance_ * F.transpose();
  covariance_.topLeftCorner<2, 2>() +=
      noise_.distance * noise_.distance * std::abs(distance) * along * along.transpose() +
      noise_.distance * noise_.distance * std::abs(sideways) * across * across.transpose();
  covariance_(2, 2) += noise_.yaw * noise_.yaw * dt;

  displacement_ += way;
  by_scale_ -= way / (1.0 + scale_);
  by_gyro_bias_ -= (moving_time_ + 0.5 * dt) * turned_way;
  turn_ += turn;
  moving_time_ += dt;
}

}  // namespace multipath_localization
