#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "rinex/ephemerides.hpp"
#include "rinex/line_reader.hpp"

namespace multipath_localization {

/// One broadcast message as RINEX prints it: the satellite, a time and lines of numbers.
class NavigationMessage {
 public:
  /// From its first line, the reader's current one. `constellation` is what files of version 2 say once for
  /// all their messages. All throw RinexError.
  NavigationMessage(const LineReader& in, std::optional<Constellation> constellation);

  /// Takes the reader's current line too.
  void add_line(const LineReader& in);

  /// As orbit and clock. `leap_seconds`: GPS time - UTC, without which the table tells it. Nothing of
  /// Galileo's F/NAV: it does not carry the health of E1.
  [[nodiscard]] std::optional<Ephemeris> ephemeris(const LineReader& in,
                                                   std::optional<int> leap_seconds) const;

 private:
  static constexpr std::size_t kMostLines = 8;

  [[nodiscard]] int data_sources() const;
  [[nodiscard]] GlonassOrbit glonass_orbit(const LineReader& in, std::optional<int> leap_seconds) const;
  [[nodiscard]] BroadcastOrbit broadcast_orbit(const LineReader& in) const;
  [[nodiscard]] double at(const LineReader& in, std::size_t line, std::size_t place) const;
  [[nodiscard]] bool healthy(const LineReader& in) const;

  SatelliteId satellite_;
  CalendarTime time_;
  bool version_2_;
  std::size_t lines_ = 0;
  std::array<std::array<std::optional<double>, 4>, kMostLines> numbers_;  ///< line 0: the clock's at 1 to 3
};

}  // namespace multipath_localization
