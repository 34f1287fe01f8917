#include "oracle.hpp"
#include "receiver/live_positioning.hpp"
#include "receiver/ubx_receiver.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

void check(const CorrectedEpoch& epoch) {
  require(epoch.satellites.size() == epoch.observations.size(), "satellites without observations");
  for (std::size_t i = 0; i < epoch.observations.size(); ++i) {
    const SatelliteObservation& seen = epoch.observations[i];
    require_finite(seen.pseudorange + seen.elevation + seen.sigma, "a pseudorange, elevation or sigma");
    require(epoch.satellites[i].at_transmission.position.allFinite(), "a satellite's place is not finite");
    require(!seen.has_doppler() || std::isfinite(seen.range_rate), "a range rate is infinite");
  }
}

}  // namespace

void ubx(const std::string& bytes) {
  LivePositioning positioning({0.0,
                               {Constellation::kGps, Constellation::kGlonass, Constellation::kGalileo,
                                Constellation::kBeidou, Constellation::kQzss}});
  UbxReceiver receiver(positioning.navigation(), [&](const ReceiverEpoch& epoch) {
    const auto corrected = positioning.correct(epoch.raw);
    require(corrected.has_value() == positioning.standing().shortage.empty(), "no epoch without a reason");
    if (corrected) check(*corrected);
  });
  for (std::size_t i = 0; i < bytes.size(); i += 7) receiver.take(std::string_view(bytes).substr(i, 7));
  for (const Ephemeris& ephemeris : positioning.navigation().ephemerides.all()) {
    require(possible(ephemeris), "an impossible orbit was kept");
  }
}

}  // namespace multipath_localization::fuzz
