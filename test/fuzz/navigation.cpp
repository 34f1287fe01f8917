#include "oracle.hpp"
#include "rinex/line_reader.hpp"
#include "rinex/navigation_file.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

void check(const Ephemeris& ephemeris, const GnssTime& time) {
  require(possible(ephemeris), "an impossible orbit was kept");
  const SatelliteState state = satellite_state(ephemeris, time);
  require(state.position.allFinite() && state.velocity.allFinite(), "a satellite's state is not finite");
  require_finite(state.clock + state.clock_drift, "a satellite's clock");
  require_finite(carrier_frequency(ephemeris) + group_delay(ephemeris), "frequency or group delay");
  require_finite(transmission_time(ephemeris, time, 2.2e7).second, "the time of transmission");
}

/// Whatever is near the instants that the corpus speaks of.
void check(const Ephemerides& ephemerides) {
  for (int hour = 0; hour < 24; hour += 2) {
    const auto time = gps_time({2024, 6, 24, hour, 0, 0.0}, TimeScale::kGps);
    for (std::size_t k = 0; k < kConstellations; ++k) {
      for (int number = 0; number < 40; ++number) {
        const Ephemeris* found = ephemerides.find({static_cast<Constellation>(k), number}, *time);
        if (found != nullptr) check(*found, *time);
      }
    }
  }
}

}  // namespace

void navigation(const std::string& bytes) {
  const auto read =
      unless_refused<RinexError>([&] { return read_navigation({written("navigation.rnx", bytes)}); });
  if (!read) return;
  check(read->ephemerides);
  for (const std::string& reason : read->left_out) require(!reason.empty(), "left out without a reason");
  if (!read->ionosphere) return;
  require(read->ionosphere->alpha.allFinite() && read->ionosphere->beta.allFinite(),
          "the ionosphere is not finite");
}

}  // namespace multipath_localization::fuzz
