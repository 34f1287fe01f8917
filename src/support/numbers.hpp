#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath_localization {

constexpr double square(double x) { return x * x; }

/// log(exp(a) + exp(b)) without overflow; minus infinity stands for the logarithm of zero.
inline double log_sum(double a, double b) {
  const double high = std::max(a, b);
  if (high == -std::numeric_limits<double>::infinity()) return high;
  return high + std::log1p(std::exp(std::min(a, b) - high));
}

}  // namespace multipath_localization
