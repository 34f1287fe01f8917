#include "simulation/code_multipath.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

double code_multipath(const Echo& echo, double spacing) {
  constexpr double kChip = 293.05;  // of the C/A code [m]
  const double delay = std::abs(echo.delay);
  const double in_phase = echo.amplitude * std::cos(echo.phase);
  const double near = delay / (1.0 + in_phase);
  const double far = 0.5 * spacing * kChip;
  const double fading_out = std::max(0.5 * ((1.0 + 0.5 * spacing) * kChip - delay), 0.0);
  const double sign = echo.delay < 0.0 ? -1.0 : 1.0;
  return sign * in_phase * std::min({near, far, fading_out});
}

}  // namespace multipath_localization
