#include "multipath_localization/core/epoch_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace multipath_localization {

namespace {

constexpr double kLargestLeverArm = 1e8;   // [m]
constexpr double kNearestSatellite = 1e7;  // [m]
constexpr double kFarthestSatellite = 1e8;

}  // namespace

bool usable(const SatelliteObservation& observation) {
  const double distance = observation.position.norm();
  return std::isfinite(observation.pseudorange) && std::isfinite(observation.elevation) &&
         std::isfinite(observation.sigma) && observation.sigma > 0.0 && distance > kNearestSatellite &&
         distance < kFarthestSatellite;
}

std::optional<Reason> defect(const PseudorangeEpoch& epoch) {
  if (!std::isfinite(epoch.stamp) || !epoch.antenna_in_base.allFinite()) return Reason::kNotFinite;
  if (epoch.antenna_in_base.cwiseAbs().maxCoeff() >= kLargestLeverArm) return Reason::kInvalidPosition;
  const auto& all = epoch.observations;
  const bool any = std::any_of(all.begin(), all.end(), [](const auto& one) { return usable(one); });
  if (!any) return Reason::kTooFewSatellites;
  return std::nullopt;
}

std::vector<SatelliteObservation> usable_observations(const PseudorangeEpoch& epoch) {
  std::vector<SatelliteObservation> kept;
  std::set<std::pair<Constellation, int>> seen;
  for (const SatelliteObservation& observation : epoch.observations) {
    if (!usable(observation)) continue;
    if (seen.emplace(observation.constellation, observation.satellite).second) kept.push_back(observation);
  }
  return kept;
}

}  // namespace multipath_localization
