#pragma once

#include <cstddef>
#include <vector>

namespace multipath_localization {

/// Systematic resampling, Eqs. (40), (43) of [NIS]: `count` ancestors, index i drawn weights[i] * count
/// times, rounded up or down, and exactly that often on average. Needs one uniform number in [0, 1). The
/// ancestors come in ascending order. Weights need not sum to 1; negative and NaN ones count as 0. When no
/// weight is positive, or their sum is not finite, they count as equal.
std::vector<std::size_t> systematic_resampling(const std::vector<double>& weights, std::size_t count,
                                               double uniform);

/// The values at `ancestors`, one for each.
template <class T>
std::vector<T> selected(const std::vector<T>& values, const std::vector<std::size_t>& ancestors) {
  std::vector<T> chosen;
  chosen.reserve(ancestors.size());
  for (const std::size_t i : ancestors) chosen.push_back(values[i]);
  return chosen;
}

}  // namespace multipath_localization
