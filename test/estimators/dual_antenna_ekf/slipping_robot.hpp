#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "estimators/dual_antenna_ekf/dual_antenna_ekf.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/motion/differential_drive.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {

inline constexpr double kBaseline = 0.3;
inline constexpr double kDegree = kPi / 180.0;

/// The robot of [KAM] on its circle to the left: wheels that slip at every step, pairs of fixes at 5 Hz.
class SlippingRobot {
 public:
  static constexpr double kStep = 0.01;  ///< [s]
  static constexpr int kStepsPerFix = 20;

  explicit SlippingRobot(std::uint64_t seed, double wheel_noise = 0.1)
      : wheel_noise_(wheel_noise), seed_(seed) {}

  Pose2 truth;
  WheelSpeeds wheels{0.2, 0.3};
  Eigen::Vector3d pose_error = Eigen::Vector3d::Zero();  ///< of every pair
  double fix_sigma = 0.004;
  double time = 0.0;

  OdometryIncrement drive() {
    RandomStream random(seed_, ++step_, 1);
    time = kStep * step_;
    const auto told = [&](const WheelSpeeds& w) {
      return OdometryIncrement{time, kStep, speed(w), yaw_rate(w, 0.35)};
    };
    WheelSpeeds slipping = wheels;
    if (speed(wheels) != 0.0) {
      slipping.left += wheel_noise_ * random.normal();
      slipping.right += wheel_noise_ * random.normal();
    }
    truth = truth * displacement(told(slipping));
    return told(wheels);
  }

  [[nodiscard]] DualAntennaFix pair() const {
    RandomStream random(seed_, step_, 2);
    const Pose2 seen{truth.x + pose_error.x(), truth.y + pose_error.y(), truth.yaw + pose_error.z()};
    const auto fix_at = [&](double y) {
      GnssFix fix;
      fix.stamp = time;
      fix.antenna_in_base = {0.0, y};
      const double east = random.normal();
      fix.position = seen * fix.antenna_in_base + fix_sigma * Eigen::Vector2d(east, random.normal());
      fix.covariance = std::max(fix_sigma * fix_sigma, 1.6e-5) * Eigen::Matrix2d::Identity();
      return fix;
    };
    const GnssFix left = fix_at(0.5 * kBaseline);
    return {time, left, fix_at(-0.5 * kBaseline)};
  }

  /// Drives on for `duration`, giving the filter everything and `observe` a look after each pair.
  template <class Observe>
  void run(Estimator& filter, double duration, const Observe& observe) {
    const auto steps = std::lround(duration / kStep);
    for (long i = 0; i < steps; ++i) {
      filter.predict(drive());
      if (step_ % kStepsPerFix != 0) continue;
      last = filter.update(pair());
      observe();
    }
  }
  void run(Estimator& filter, double duration) {
    run(filter, duration, [] {});
  }

  Innovation last;

 private:
  double wheel_noise_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
};

inline double heading_error(const Estimator& filter, const Pose2& truth) {
  return angle_difference(filter.estimate().pose.yaw, truth.yaw);
}

inline double distance(const Estimator& filter, const Pose2& truth) {
  return position_error(filter.estimate(), truth).norm();
}

inline PosePrior at(const Pose2& pose) {
  PosePrior prior;
  prior.pose = pose;
  prior.covariance = Eigen::Vector3d(1e-4, 1e-4, 1e-3).asDiagonal();
  return prior;
}

}  // namespace multipath_localization
