#include "multipath_localization/models/pseudorange/signal_weights.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/models/pseudorange/pseudorange.hpp"

namespace multipath_localization {

namespace {

constexpr double kStrongCn0 = 45.0;       // [dB-Hz]
constexpr double kGreatestLoss = 30.0;    // [dB]
constexpr double kLowestElevation = 0.1;  // [rad]

double variance_factor(const SatelliteObservation& observation) {
  const double sine = std::sin(std::max(observation.elevation, kLowestElevation));
  const double loss =
      std::isfinite(observation.cn0) ? std::clamp(kStrongCn0 - observation.cn0, 0.0, kGreatestLoss) : 0.0;
  return 0.5 * (1.0 + 1.0 / (sine * sine)) * std::pow(10.0, 0.1 * loss);
}

}  // namespace

std::vector<double> signal_weights(const std::vector<SatelliteObservation>& observations) {
  std::vector<double> weights;
  weights.reserve(observations.size());
  for (const SatelliteObservation& observation : observations) {
    const double sigma = believed_sigma(observation);
    weights.push_back(1.0 / (sigma * sigma * variance_factor(observation)));
  }
  return weights;
}

}  // namespace multipath_localization
