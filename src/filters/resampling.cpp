#include "multipath_localization/filters/resampling.hpp"

#include <cmath>

namespace multipath_localization {

std::vector<std::size_t> systematic_resampling(const std::vector<double>& weights, std::size_t count,
                                               double uniform) {
  std::vector<std::size_t> ancestors;
  if (weights.empty()) return ancestors;
  double total = 0.0;
  std::size_t last_positive = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] > 0.0)) continue;
    total += weights[i];
    last_positive = i;
  }
  if (!(total > 0.0) || !std::isfinite(total)) {
    return systematic_resampling(std::vector<double>(weights.size(), 1.0), count, uniform);
  }
  ancestors.reserve(count);
  double reached = 0.0;
  for (std::size_t i = 0; i <= last_positive; ++i) {
    if (!(weights[i] > 0.0)) continue;
    reached += weights[i];
    // Rounding may leave the sum short of the last comb tooth, which then belongs to the last positive
    // weight.
    while (ancestors.size() < count &&
           (i == last_positive || (static_cast<double>(ancestors.size()) + uniform) * total <
                                      reached * static_cast<double>(count))) {
      ancestors.push_back(i);
    }
  }
  return ancestors;
}

}  // namespace multipath_localization
