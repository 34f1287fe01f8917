#include "multipath_localization/filters/resampling.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

/// A weight that is positive, or nothing.
double usable(double weight) { return weight > 0.0 ? weight : 0.0; }

double total_of(const std::vector<double>& weights) {
  double total = 0.0;
  for (const double weight : weights) total += usable(weight);
  return total;
}

}  // namespace

std::vector<std::size_t> systematic_resampling(const std::vector<double>& weights, std::size_t count,
                                               double uniform) {
  std::vector<std::size_t> ancestors;
  if (weights.empty()) return ancestors;
  const double sum = total_of(weights);
  const bool even = !(sum > 0.0) || !std::isfinite(sum);
  const double total = even ? static_cast<double>(weights.size()) : sum;
  ancestors.reserve(count);
  double reached = 0.0;
  std::size_t last_positive = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double weight = even ? 1.0 : usable(weights[i]);
    if (weight == 0.0) continue;
    last_positive = i;
    reached += weight;
    while (ancestors.size() < count &&
           (static_cast<double>(ancestors.size()) + uniform) * total < reached * static_cast<double>(count)) {
      ancestors.push_back(i);
    }
  }
  // Rounding may leave the sum short of the last comb tooth, which then belongs to the last positive weight.
  ancestors.resize(count, last_positive);
  return ancestors;
}

}  // namespace multipath_localization
