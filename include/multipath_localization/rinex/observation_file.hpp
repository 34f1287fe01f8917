#pragma once

#include <limits>
#include <string>
#include <vector>

#include "multipath_localization/rinex/gnss_time.hpp"
#include "multipath_localization/rinex/satellite_id.hpp"

namespace multipath_localization {

/// What a receiver measured of one satellite on the one signal that is used of each.
struct RawObservation {
  SatelliteId satellite;
  double pseudorange = 0.0;                                   ///< [m]
  double doppler = std::numeric_limits<double>::quiet_NaN();  ///< positive when approaching [Hz]; NaN: none
  double cn0 = std::numeric_limits<double>::quiet_NaN();      ///< [dB-Hz]; NaN: not told
};

/// All of one instant, by the receiver's clock.
struct RawEpoch {
  GnssTime time;
  std::vector<RawObservation> observations;
};

/// What an observation file holds.
struct ObservationLog {
  std::vector<RawEpoch> epochs;       ///< later and later
  std::vector<std::string> left_out;  ///< epochs that could not be used: file, line and reason of each
};

/// Reads RINEX observations 2.00 to 2.12 and 3.00 to 3.05. Of each satellite it takes the pseudorange of the
/// first of these codes that the satellite has, with the Doppler shift and C/N0 of the same code:
///   GPS C1C C1X C1L C1S C1P C1W; GLONASS C1C C1P; Galileo C1C C1X C1B; BeiDou (B1I) C2I C2X C1I;
///   QZSS C1C C1X C1L C1S; in version 2 C1 P1, of BeiDou C2.
/// C1I is what version 3.02 calls B1I. Where there is no C/N0 the digit of the signal's strength gives it to
/// 3 dB. SBAS and NavIC are passed over, and so are records of cycle slips and of events. An epoch is
/// left out that the file breaks off in or that is no later than the one before. Throws RinexError for all
/// else that cannot be read, a satellite twice in an epoch too.
ObservationLog read_observations(const std::string& file);

}  // namespace multipath_localization
