#pragma once

#include <array>
#include <optional>

#include "receiver/bits.hpp"
#include "receiver/subframe.hpp"
#include "rinex/glonass_orbit.hpp"

namespace multipath_localization {

/// Puts together what one satellite of GLONASS broadcasts, GLONASS ICD 5.1, 4.4 and 4.5.
class GlonassMessage {
 public:
  /// Takes a string of 85 bits, its first bit the highest of the first word. Gives the orbit that is whole
  /// with it: strings 1 to 4 of one frame. Strings that the Hamming code refutes are passed over.
  std::optional<GlonassOrbit> add(const Subframe& subframe, const ReceptionTime& now);

 private:
  struct String {
    BitString bits;
    GnssTime received;
  };
  [[nodiscard]] GlonassOrbit orbit(const ReceptionTime& now) const;

  std::array<std::optional<String>, 4> strings_;
};

/// Whether the check bits of a string of 85 bits, GLONASS ICD 5.1, 4.7, find no error in it.
bool glonass_string_holds(const BitString& bits);

}  // namespace multipath_localization
