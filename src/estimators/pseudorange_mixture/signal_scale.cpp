#include "estimators/pseudorange_mixture/signal_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace multipath_localization {

namespace {

constexpr double kStrongPart = 0.1;  // of all signals
constexpr double kMemory = 300.0;    // longer than a street, shorter than a change of antenna [s]

}  // namespace

void SignalScale::add(const std::vector<SatelliteObservation>& observations, double duration) {
  const double kept = std::exp(-duration / kMemory);
  for (double& time : seen_) time *= kept;
  for (const SatelliteObservation& observation : observations) {
    if (!std::isfinite(observation.cn0)) continue;
    const double bin = std::clamp(observation.cn0, 0.0, static_cast<double>(kBins - 1));
    seen_[static_cast<std::size_t>(bin)] += duration;
  }
}

double SignalScale::strong() const {
  const double weaker = (1.0 - kStrongPart) * std::accumulate(seen_.begin(), seen_.end(), 0.0);
  if (weaker <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  double below = 0.0;
  std::size_t bin = 0;
  while (bin + 1 < kBins && below + seen_[bin] < weaker) below += seen_[bin++];
  return static_cast<double>(bin) + (weaker - below) / seen_[bin];
}

}  // namespace multipath_localization
