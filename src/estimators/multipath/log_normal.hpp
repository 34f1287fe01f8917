#pragma once

#include <Eigen/Core>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

/// Logarithm of the normal density of a deviation with that variance.
inline double log_normal(double deviation, double variance) {
  return -0.5 * (square(deviation) / variance + std::log(2.0 * kPi * variance));
}

/// The same in two dimensions, with covariance S, symmetric and positive definite.
inline double log_normal(const Eigen::Vector2d& v, const Eigen::Matrix2d& S) {
  const double determinant = S(0, 0) * S(1, 1) - S(0, 1) * S(0, 1);
  const double squared =
      (S(1, 1) * v.x() * v.x() - 2.0 * S(0, 1) * v.x() * v.y() + S(0, 0) * v.y() * v.y()) / determinant;
  return -0.5 * (squared + std::log(determinant)) - std::log(2.0 * kPi);
}

}  // namespace multipath_localization::multipath
