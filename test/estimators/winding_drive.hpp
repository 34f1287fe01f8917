#pragma once

#include <cmath>
#include <cstdint>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/estimators/estimator.hpp"

namespace multipath_localization {

inline constexpr double kStep = 0.02;
inline constexpr int kStepsPerFix = 10;

/// A robot on a winding way at 2 m/s with noisy fixes, and an offset on demand.
class WindingDrive {
 public:
  explicit WindingDrive(std::uint64_t seed) : seed_(seed) {}

  Pose2 truth{3.0, -2.0, 2.0};
  Eigen::Vector2d antenna = Eigen::Vector2d(0.4, -0.1);
  double speed = 2.0;
  double time = 0.0;

  OdometryIncrement next() {
    time += kStep;
    const OdometryIncrement u{time, kStep, speed, 0.3 * std::sin(0.3 * time)};
    truth = truth * displacement(u);
    return u;
  }

  GnssFix fix() {
    RandomStream random(seed_, fixes_++, 0);
    GnssFix fix;
    fix.stamp = time;
    fix.position = truth * antenna + 0.3 * Eigen::Vector2d(random.normal(), random.normal());
    fix.covariance = 0.09 * Eigen::Matrix2d::Identity();
    fix.antenna_in_base = antenna;
    return fix;
  }

  void run(Estimator& filter, double duration, const Eigen::Vector2d& offset = Eigen::Vector2d::Zero()) {
    const auto steps = std::lround(duration / kStep);
    for (long i = 1; i <= steps; ++i) {
      filter.predict(next());
      if (i % kStepsPerFix != 0) continue;
      GnssFix z = fix();
      z.position += offset;
      last = filter.update(z);
    }
  }

  double error(const Estimator& filter) const {
    return (filter.estimate().pose.position() - truth.position()).norm();
  }

  Innovation last;

 private:
  std::uint64_t seed_;
  std::uint32_t fixes_ = 0;
};

/// A prior there. The variances tell the function from that of matched_robot.hpp in the same program.
inline PosePrior prior_at(const Pose2& pose, const Eigen::Vector3d& variances = {0.04, 0.04, 0.0025}) {
  PosePrior prior;
  prior.pose = pose;
  prior.covariance = variances.asDiagonal();
  return prior;
}

}  // namespace multipath_localization
