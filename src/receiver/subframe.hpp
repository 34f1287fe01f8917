#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "rinex/gnss_time.hpp"
#include "rinex/satellite_id.hpp"

namespace multipath_localization {

/// A piece of a satellite's navigation message as u-blox receivers pass it on: a subframe of GPS, QZSS and
/// BeiDou, a pair of pages of Galileo, a string of GLONASS.
struct Subframe {
  SatelliteId satellite;
  int channel = 0;                   ///< of GLONASS, k: L1 is at 1602 MHz + k 562.5 kHz
  std::vector<std::uint32_t> words;  ///< as in UBX-RXM-SFRBX
};

/// When something was received, by the receiver.
struct ReceptionTime {
  GnssTime gps;
  int leap_seconds = 0;  ///< GPS time - UTC
};

/// Of the instants at which the second of a `period` (a day, a week) is `second`, the one nearest to `near`.
/// Broadcast references are of the hours around their reception, which tells the week that they leave out.
/// `second`: on the scale of GPS, of any period [s].
inline GnssTime nearest(const GnssTime& near, double second, double period) {
  return GnssTime{near.week, 0.0} + (second + period * std::round((near.second - second) / period));
}

}  // namespace multipath_localization
