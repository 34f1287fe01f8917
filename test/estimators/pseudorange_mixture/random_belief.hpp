#pragma once

#include "estimators/pseudorange_mixture/belief.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

/// A belief with everything correlated with everything, of sizes as they occur.
inline Belief random_belief(std::uint64_t seed) {
  RandomStream random(seed, 0, 0);
  Belief::Vector sigma;
  sigma << 1.0, 1.0, 0.2, 0.02, 0.004;
  Belief belief;
  Belief::Matrix root;
  for (int i = 0; i < kPlanarSize; ++i) {
    belief.mean(i) = sigma(i) * random.normal();
    for (int j = 0; j < kPlanarSize; ++j) root(i, j) = sigma(i) * random.normal() / 2.0;
  }
  belief.mean(kYaw) = 2.0 * random.normal();
  belief.covariance = root * root.transpose();
  return belief;
}

/// d(antenna) / d(state) by central differences.
inline Eigen::Matrix<double, 2, kPlanarSize> numerical_antenna_jacobian(
    const Belief& belief, const Eigen::Vector2d& antenna_in_base) {
  constexpr double kDelta = 1e-6;
  const auto antenna_of = [&](const Belief::Vector& state) {
    const Pose2 pose{state(kX), state(kY), state(kYaw)};
    return Eigen::Vector2d(pose * antenna_in_base);
  };
  Eigen::Matrix<double, 2, kPlanarSize> H;
  for (int i = 0; i < kPlanarSize; ++i) {
    const Belief::Vector step = kDelta * Belief::Vector::Unit(i);
    H.col(i) = (antenna_of(belief.mean + step) - antenna_of(belief.mean - step)) / (2.0 * kDelta);
  }
  return H;
}

}  // namespace multipath_localization
