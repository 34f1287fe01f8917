#pragma once

#include <array>
#include <optional>

#include "receiver/bits.hpp"
#include "receiver/subframe.hpp"
#include "rinex/broadcast_orbit.hpp"

namespace multipath_localization {

/// Puts together what one satellite of Galileo broadcasts on E1 B (I/NAV), Galileo OS SIS ICD, 4.3.
class GalileoMessage {
 public:
  /// Takes a pair of pages, even and odd, as eight words of 32 bits. Gives the orbit that is whole with it:
  /// words 1 to 4 of one issue of data and word 5. Alert pages, and what its CRC refutes, are passed over.
  std::optional<BroadcastOrbit> add(const Subframe& subframe, const ReceptionTime& now);

 private:
  std::array<std::optional<BitString>, 5> words_;
};

}  // namespace multipath_localization
