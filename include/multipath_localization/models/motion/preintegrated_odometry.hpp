#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// How far the wheel odometry of a robot can be trusted.
struct OdometryNoise {
  double distance = 0.006;
  double yaw = 0.003;
  double scale_sigma = 0.02;
  double gyro_bias_sigma = 0.004;
  double scale_walk = 1e-4;
  double gyro_bias_walk = 2e-5;

  void fields(ParameterVisitor& field);
};

/// Odometry summed up between two fixes, once for all hypotheses.
///
/// All quantities are in the base frame at the start of the sum and linearised at the odometry constants
/// given to `restart`: the speed measured, forwards and sideways, is (1 + scale) times the true one, the yaw
/// rate measured is gyro_bias too high. Nothing but time passes while the wheels stand still, so that a
/// parked robot neither diffuses nor turns.
class PreintegratedOdometry {
 public:
  explicit PreintegratedOdometry(const OdometryNoise& noise) : noise_(noise) {}

  /// Of the increments from now on.
  void set_noise(const OdometryNoise& noise) { noise_ = noise; }
  void restart(double scale, double gyro_bias);
  void add(const OdometryIncrement& increment);

  /// Displacement [m] with the odometry constants of a hypothesis.
  [[nodiscard]] Eigen::Vector2d displacement(double scale, double gyro_bias) const {
    return displacement_ + by_scale_ * (scale - scale_) + by_gyro_bias_ * (gyro_bias - gyro_bias_);
  }
  /// Turn [rad], likewise.
  [[nodiscard]] double turn(double gyro_bias) const {
    return turn_ - moving_time_ * (gyro_bias - gyro_bias_);
  }

  [[nodiscard]] const Eigen::Vector2d& by_scale() const { return by_scale_; }  ///< d displacement / d scale
  [[nodiscard]] const Eigen::Vector2d& by_gyro_bias() const { return by_gyro_bias_; }  ///< [m s / rad]
  [[nodiscard]] const Eigen::Matrix3d& covariance() const { return covariance_; }      ///< of x, y, yaw
  [[nodiscard]] double moving_time() const { return moving_time_; }                    ///< [s]
  [[nodiscard]] double duration() const { return duration_; }                          ///< [s]

 private:
  OdometryNoise noise_;
  double scale_ = 0.0;
  double gyro_bias_ = 0.0;
  Eigen::Vector2d displacement_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d by_scale_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d by_gyro_bias_ = Eigen::Vector2d::Zero();
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  double turn_ = 0.0;
  double moving_time_ = 0.0;
  double duration_ = 0.0;
};

}  // namespace multipath_localization
