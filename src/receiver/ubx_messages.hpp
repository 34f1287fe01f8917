#pragma once

#include <optional>
#include <string_view>

#include "receiver/subframe.hpp"
#include "rinex/observation_file.hpp"

namespace multipath_localization {

/// What a receiver says at one instant.
struct ReceiverEpoch {
  RawEpoch raw;
  std::optional<int> leap_seconds;  ///< GPS time - UTC, where the receiver knows
  bool clock_reset = false;         ///< it has just moved its clock, by whole milliseconds as a rule
};

/// The payload of UBX-RXM-RAWX (u-blox 8, M8 and 9 interface descriptions). Of each satellite it takes the
/// pseudorange of the first of these signals that is valid, with Doppler and C/N0 of the same: L1 C/A, E1 C,
/// E1 B, B1I, B1C pilot, B1C data, GLONASS L1OF. SBAS, NavIC, GLONASS satellites whose slot is not known and
/// carrier phases are passed over. Nothing where the payload is none, or before the receiver knows the time.
std::optional<ReceiverEpoch> read_rawx(std::string_view payload);

/// The payload of UBX-RXM-SFRBX, of the signals that carry LNAV, I/NAV (E1 B), D1 and D2 (B1I), and GLONASS
/// L1OF; nothing of others.
std::optional<Subframe> read_sfrbx(std::string_view payload);

}  // namespace multipath_localization
