#pragma once

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

/// By how much the ionosphere delays a signal of this elevation [rad] more than one at the zenith.
/// IS-GPS-200, 20.3.3.5.2.5; below the horizon it is that of the horizon.
inline double ionospheric_slant(double elevation) {
  const double semicircles = std::max(elevation, 0.0) / kPi;
  return 1.0 + 16.0 * std::pow(0.53 - semicircles, 3);
}

}  // namespace multipath_localization
