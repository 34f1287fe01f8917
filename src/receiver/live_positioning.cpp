#include "receiver/live_positioning.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kFewest = 4;  // satellites for a first position

std::string shortage_of(const LivePositioning::Standing& standing) {
  if (standing.heard == 0) return "no satellite heard";
  if (standing.with_ephemeris >= kFewest) return "no position by the satellites heard so far";
  return std::to_string(standing.with_ephemeris) + " of " + std::to_string(standing.heard) +
         " satellites with an ephemeris so far, 4 are needed: they broadcast it every half minute";
}

}  // namespace

std::optional<CorrectedEpoch> LivePositioning::correct(const RawEpoch& raw) {
  standing_ = {};
  standing_.heard = raw.observations.size();
  for (const RawObservation& observation : raw.observations) {
    const bool known = navigation_.ephemerides.find(observation.satellite, raw.time) != nullptr;
    standing_.with_ephemeris += known ? 1 : 0;
  }
  std::optional<CorrectedEpoch> corrected = positioning_.correct(raw);
  if (corrected) {
    standing_.used = corrected->observations.size();
  } else {
    standing_.shortage = shortage_of(standing_);
  }
  return corrected;
}

}  // namespace multipath_localization
