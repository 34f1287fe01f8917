#pragma once

#include <cmath>

namespace multipath_localization {

inline constexpr double kPi = 3.14159265358979323846;

/// The same angle in (-pi, pi]. NaN and infinities give NaN.
inline double wrap_angle(double angle) {
  if (angle > -kPi && angle <= kPi) return angle;  // what `remainder` would give, ten times as slowly
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

/// The smallest turn from `from` to `to`, in (-pi, pi].
inline double angle_difference(double to, double from) { return wrap_angle(to - from); }

}  // namespace multipath_localization
