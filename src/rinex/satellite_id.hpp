#pragma once

#include <optional>
#include <tuple>

#include "multipath_localization/core/constellation.hpp"

namespace multipath_localization {

/// A satellite as RINEX names it.
struct SatelliteId {
  Constellation constellation = Constellation::kGps;
  int number = 0;  ///< PRN; GLONASS: slot; QZSS: PRN - 192

  friend bool operator<(const SatelliteId& a, const SatelliteId& b) {
    return std::tie(a.constellation, a.number) < std::tie(b.constellation, b.number);
  }
  friend bool operator==(const SatelliteId& a, const SatelliteId& b) {
    return a.constellation == b.constellation && a.number == b.number;
  }
};

/// G, R, E, C, J; nothing for another letter.
std::optional<Constellation> constellation_of_letter(char letter);

char letter_of(Constellation constellation);

}  // namespace multipath_localization
