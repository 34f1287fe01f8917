#pragma once

#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "rinex/broadcast_orbit.hpp"
#include "rinex/glonass_orbit.hpp"

namespace multipath_localization {

/// What a satellite broadcasts of its orbit and clock.
using Ephemeris = std::variant<BroadcastOrbit, GlonassOrbit>;

constexpr double kL1Frequency = 1575.42e6;  ///< of GPS, QZSS and Galileo, which calls it E1 [Hz]

SatelliteState satellite_state(const Ephemeris& ephemeris, const GnssTime& time);

bool possible(const Ephemeris& ephemeris);

/// Of the signal whose pseudoranges are used: L1, E1, B1I (or B1C) or GLONASS's channel of L1 [Hz].
double carrier_frequency(const Ephemeris& ephemeris, bool b1c = false);

/// By how much that signal leaves later than the satellite's clock says [s]; of B1C, which the messages of
/// RINEX 3 do not tell, that of B1I, metres off.
double group_delay(const Ephemeris& ephemeris);

/// All that satellites broadcast in some span of time.
class Ephemerides {
 public:
  void add(const Ephemeris& ephemeris);

  /// The same of a stream that never ends: takes the place of one of the same reference, and leaves of the
  /// satellite the last 40, which are all that may be used (Galileo's come every ten minutes).
  void update(const Ephemeris& ephemeris);

  /// Satellites of which there is one that may be used at that time.
  [[nodiscard]] std::vector<SatelliteId> usable(const GnssTime& time) const;

  /// All that are held, satellite after satellite.
  [[nodiscard]] std::vector<Ephemeris> all() const;

  /// The first and the last reference time, nothing without ephemerides.
  [[nodiscard]] std::optional<std::pair<GnssTime, GnssTime>> span() const { return span_; }

  /// The one of the satellite whose reference time is nearest; of two equally near the one that was sent
  /// later, since health changes without a new reference, else the one that was added later. Nothing when
  /// that is farther off than it may be used for (GPS and QZSS 2 h, Galileo 4 h, BeiDou 6 h, GLONASS 30 min)
  /// or calls the satellite unhealthy.
  [[nodiscard]] const Ephemeris* find(const SatelliteId& satellite, const GnssTime& time) const;

 private:
  std::map<SatelliteId, std::vector<Ephemeris>> by_satellite_;
  std::optional<std::pair<GnssTime, GnssTime>> span_;
};

/// When the signal left that a receiver heard at `reception`, by its own clock, as a pseudorange [m]: the
/// receiver's clock error is in both and goes out. The ephemeris has to be a possible one.
GnssTime transmission_time(const Ephemeris& ephemeris, const GnssTime& reception, double pseudorange);

}  // namespace multipath_localization
