#pragma once

#include <optional>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "rinex/navigation_file.hpp"
#include "rinex/observation_file.hpp"

namespace multipath_localization {

/// A satellite that was heard and whose orbit is known: what can be said without knowing where the antenna
/// is.
struct TrackedSatellite {
  SatelliteId satellite;
  SatelliteState at_transmission;
  double frequency = 0.0;                              ///< of the carrier [Hz]
  double pseudorange = 0.0;                            ///< without satellite clock and group delay [m]
  double range_rate = SatelliteObservation::kUnknown;  ///< without satellite clock drift [m/s]; NaN: none
  double cn0 = SatelliteObservation::kUnknown;         ///< [dB-Hz]; NaN: not told
};

/// Nothing where there is no usable and possible ephemeris, or no time of flight below a second that ends at
/// a satellite.
std::optional<TrackedSatellite> track(const RawObservation& raw, const GnssTime& reception,
                                      const Ephemerides& ephemerides);

/// As seen from an antenna at the datum of `map`: elevation, declared standard deviation, and the pseudorange
/// without troposphere and ionosphere (as far as there is a model of it).
SatelliteObservation seen_from(const LocalFrame& map, const TrackedSatellite& tracked,
                               const GnssTime& reception,
                               const std::optional<KlobucharCoefficients>& ionosphere);

/// Standard deviation of a corrected pseudorange in open sky [m]:
///   sigma^2 = (0.8 m / sin(elevation))^2 + (1 m)^2 10^((45 - C/N0) / 10).
/// The first term is what the models leave of the atmosphere, the second the noise of the code and short
/// multipath after the sigma-epsilon model (Hartinger and Brunner 1999). An unknown C/N0 counts as 38 dB-Hz,
/// an elevation below kLowestElevation as that. Reflected signals are outside of it.
double pseudorange_sigma(double elevation, double cn0);

}  // namespace multipath_localization
