#pragma once

#include <cmath>
#include <cstdint>

namespace multipath_localization {

/// How many periods of a `rate` [Hz] have passed at `time` [s]; one that has all but rounding counts.
inline std::int64_t periods(double time, double rate) {
  return static_cast<std::int64_t>(std::floor(time * rate + 1e-6));
}

}  // namespace multipath_localization
