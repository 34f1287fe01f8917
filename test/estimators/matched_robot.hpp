#pragma once

#include <cmath>
#include <cstdint>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization {

/// A robot that behaves exactly as the filter assumes, odometry at 50 Hz, fixes at 5 Hz.
class MatchedRobot {
 public:
  static constexpr double kStep = 0.02;  ///< [s]
  static constexpr int kStepsPerFix = 10;

  MatchedRobot(const OdometryNoise& noise, std::uint64_t seed) : noise_(noise), seed_(seed) {
    RandomStream random(seed_, 0, 0);
    errors_ = {noise_.scale_sigma * random.normal(), noise_.gyro_bias_sigma * random.normal()};
  }

  Pose2 truth;
  Eigen::Vector2d antenna = Eigen::Vector2d(0.4, -0.1);
  double fix_sigma = 0.5;
  double speed = 2.0;
  double time = 0.0;

  /// One increment as measured; the truth moves by a noisy one.
  OdometryIncrement drive() {
    RandomStream random(seed_, ++step_, 1);
    time += kStep;
    const double yaw_rate = 0.3 * std::sin(0.2 * time);
    const OdometryIncrement measured{time, kStep, speed, yaw_rate};
    truth = moved(truth, measured, errors_);
    const double along = noise_.distance * std::sqrt(std::abs(speed) * kStep) * random.normal();
    truth.x += along * std::cos(truth.yaw);
    truth.y += along * std::sin(truth.yaw);
    truth.yaw = wrap_angle(truth.yaw + noise_.yaw * std::sqrt(kStep) * random.normal());
    return measured;
  }

  GnssFix fix() {
    RandomStream random(seed_, step_, 2);
    GnssFix fix;
    fix.stamp = time;
    fix.position = truth * antenna + fix_sigma * Eigen::Vector2d(random.normal(), random.normal());
    fix.covariance = fix_sigma * fix_sigma * Eigen::Matrix2d::Identity();
    fix.antenna_in_base = antenna;
    return fix;
  }

  /// Drives on for `duration`, giving the filter everything but fixes moved by `offset`.
  void run(Estimator& filter, double duration, const Eigen::Vector2d& offset = Eigen::Vector2d::Zero()) {
    const auto steps = std::lround(duration / kStep);
    for (long i = 1; i <= steps; ++i) {
      filter.predict(drive());
      if (i % kStepsPerFix != 0) continue;
      GnssFix z = fix();
      z.position += offset;
      last = filter.update(z);
    }
  }

  Innovation last;

 private:
  OdometryNoise noise_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  OdometerErrors errors_;
};

inline PosePrior prior_at(const Pose2& pose) {
  PosePrior prior;
  prior.pose = pose;
  prior.covariance = Eigen::Vector3d(0.25, 0.25, 0.01).asDiagonal();
  return prior;
}

}  // namespace multipath_localization
