#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rinex/atmosphere.hpp"
#include "rinex/ephemerides.hpp"

namespace multipath_localization {

/// What navigation files hold.
struct Navigation {
  Ephemerides ephemerides;
  std::optional<KlobucharCoefficients> ionosphere;  ///< GPS's, else QZSS's; the first file's that has them
  std::vector<std::string> left_out;  ///< messages that could not be used: file, line and reason of each
};

/// Reads RINEX navigation: 3.00 to 3.05 of any mix of systems, 2.00 to 2.12 of GPS (N) or GLONASS (G),
/// several files in one too; a message that begins with its system's letter is of version 3 whatever the
/// header says. SBAS and NavIC are passed over, and so is Galileo's F/NAV, which does not carry the health of
/// E1. Healthy is a satellite whose signals all are: of Galileo E1-B alone, and only with an accuracy told;
/// of QZSS all but L1C/B. GLONASS's times are UTC: leap seconds are those of the file's header, without it
/// the table's. One message that cannot be used harms no other. Throws RinexError where there is no such file
/// or header.
Navigation read_navigation(const std::vector<std::string>& files);

}  // namespace multipath_localization
