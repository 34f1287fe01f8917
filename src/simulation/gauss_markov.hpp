#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

/// Two independent standard normal numbers times `sigma`.
Eigen::Vector2d normal2(RandomStream& random, double sigma);

/// A first-order Gauss-Markov process of two components: an error that wanders about zero.
class GaussMarkov2 {
 public:
  /// Starts in its stationary distribution of standard deviation `sigma` per component, with a correlation
  /// time of `time_constant` [s].
  GaussMarkov2(double sigma, double time_constant, RandomStream random)
      : sigma_(sigma), time_constant_(time_constant), value_(normal2(random, sigma)) {}

  /// Moves on by `duration` [s].
  void step(double duration, RandomStream& random);

  [[nodiscard]] const Eigen::Vector2d& value() const { return value_; }

 private:
  double sigma_;
  double time_constant_;
  Eigen::Vector2d value_;
};

}  // namespace multipath_localization
