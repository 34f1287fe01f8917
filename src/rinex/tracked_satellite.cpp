#include "rinex/tracked_satellite.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kLongestFlight = 1.0;    // [s], with a receiver's clock error
constexpr double kNearestOrbit = 1.5e7;   // from the Earth's centre [m]
constexpr double kFarthestOrbit = 6e7;    // [m]
constexpr double kAtmosphereSigma = 0.8;  // at the zenith [m]
constexpr double kCodeSigma = 1.0;        // at kGoodCn0 [m]
constexpr double kGoodCn0 = 45.0;         // [dB-Hz]
constexpr double kUnknownCn0 = 38.0;      // [dB-Hz]

bool possible(const SatelliteState& state) {
  const double radius = state.position.norm();
  return radius > kNearestOrbit && radius < kFarthestOrbit && state.velocity.allFinite() &&
         std::isfinite(state.clock) && std::isfinite(state.clock_drift);
}

}  // namespace

std::optional<TrackedSatellite> track(const RawObservation& raw, const GnssTime& reception,
                                      const Ephemerides& ephemerides) {
  const Ephemeris* ephemeris = ephemerides.find(raw.satellite, reception);
  const bool flown = raw.pseudorange > 0.0 && raw.pseudorange < kLongestFlight * kSpeedOfLight;
  if (ephemeris == nullptr || !possible(*ephemeris) || !flown) return std::nullopt;
  TrackedSatellite tracked;
  tracked.satellite = raw.satellite;
  const GnssTime transmission = transmission_time(*ephemeris, reception, raw.pseudorange);
  tracked.at_transmission = satellite_state(*ephemeris, transmission);
  if (!possible(tracked.at_transmission)) return std::nullopt;
  tracked.frequency = carrier_frequency(*ephemeris, raw.b1c);
  tracked.pseudorange =
      raw.pseudorange + kSpeedOfLight * (tracked.at_transmission.clock - group_delay(*ephemeris));
  tracked.range_rate =
      kSpeedOfLight * (tracked.at_transmission.clock_drift - raw.doppler / tracked.frequency);
  tracked.cn0 = raw.cn0;
  return tracked;
}

SatelliteObservation seen_from(const LocalFrame& map, const TrackedSatellite& tracked,
                               const GnssTime& reception,
                               const std::optional<KlobucharCoefficients>& ionosphere) {
  SatelliteObservation seen;
  seen.constellation = tracked.satellite.constellation;
  seen.satellite = tracked.satellite.number;
  seen.position = map.satellite_to_map(tracked.at_transmission.position);
  seen.velocity =
      map.satellite_velocity_to_map(tracked.at_transmission.position, tracked.at_transmission.velocity);
  const Direction direction = direction_of(seen.position);
  seen.elevation = direction.elevation;
  seen.sigma = pseudorange_sigma(seen.elevation, tracked.cn0);
  seen.cn0 = tracked.cn0;
  seen.range_rate = tracked.range_rate;
  seen.pseudorange = tracked.pseudorange - saastamoinen_delay(map.datum(), seen.elevation);
  if (ionosphere) {
    const double dispersion = kL1Frequency * kL1Frequency / (tracked.frequency * tracked.frequency);
    seen.pseudorange -= dispersion * klobuchar_delay(*ionosphere, map.datum(), direction, reception);
  }
  return seen;
}

double pseudorange_sigma(double elevation, double cn0) {
  const double atmosphere = kAtmosphereSigma / std::sin(std::max(elevation, kLowestElevation));
  const double lost_db = kGoodCn0 - (std::isfinite(cn0) ? cn0 : kUnknownCn0);
  return std::sqrt(atmosphere * atmosphere + kCodeSigma * kCodeSigma * std::pow(10.0, lost_db / 10.0));
}

}  // namespace multipath_localization
