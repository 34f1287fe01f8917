#pragma once

#include <array>
#include <optional>

#include "receiver/bits.hpp"
#include "receiver/subframe.hpp"
#include "rinex/broadcast_orbit.hpp"

namespace multipath_localization {

/// Puts together what one satellite of BeiDou broadcasts on B1I: D1, or D2 of a geostationary one (BeiDou
/// B1I ICD, 5.2 and 5.3).
class BeidouMessage {
 public:
  /// Takes a subframe, ten words of 30 bits that the receiver has checked. Gives the orbit that is whole with
  /// it: subframes 1 to 3 of one frame of D1, pages 1 to 10 of subframe 1 of one round of D2.
  std::optional<BroadcastOrbit> add(const Subframe& subframe, const ReceptionTime& now);

 private:
  /// A subframe, and the second at which the round that it is of began, by its own word.
  struct Part {
    BitString bits;
    std::uint64_t round = 0;
  };
  /// Whether parts 1 to `count` are there and of one round.
  [[nodiscard]] bool whole(std::size_t count) const;
  [[nodiscard]] BroadcastOrbit orbit_of_d1(const ReceptionTime& now) const;
  [[nodiscard]] BroadcastOrbit orbit_of_d2(const ReceptionTime& now) const;

  std::array<std::optional<Part>, 10> parts_;
};

}  // namespace multipath_localization
