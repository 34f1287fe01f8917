#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "receiver/bits.hpp"
#include "receiver/subframe.hpp"
#include "rinex/atmosphere.hpp"
#include "rinex/broadcast_orbit.hpp"

namespace multipath_localization {

/// Puts together what one satellite of GPS or QZSS broadcasts on L1 C/A (LNAV), IS-GPS-200, 20.3.3.
class GpsMessage {
 public:
  /// Takes a subframe, ten words of 30 bits whose parity the receiver has checked and whose polarity it has
  /// mended. Gives the orbit that is whole with it: subframes 1 to 3 of one issue of data.
  std::optional<BroadcastOrbit> add(const Subframe& subframe, const ReceptionTime& now);

 private:
  std::array<std::optional<BitString>, 3> subframes_;
};

/// The model of the ionosphere in page 18 of subframe 4; nothing in any other.
std::optional<KlobucharCoefficients> gps_ionosphere(const Subframe& subframe);

}  // namespace multipath_localization
