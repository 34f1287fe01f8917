#pragma once

#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/rinex/atmosphere.hpp"
#include "multipath_localization/rinex/ephemerides.hpp"

namespace multipath_localization {

/// What navigation files hold.
struct Navigation {
  Ephemerides ephemerides;
  std::optional<KlobucharCoefficients> ionosphere;  ///< GPS's, else QZSS's; the first file's that has them
};

/// Reads RINEX navigation: 3.00 to 3.05 of any mix of systems, 2.00 to 2.12 of GPS (N) or GLONASS (G). SBAS
/// and NavIC are passed over. Healthy is what calls the L1, E1 or B1I signal healthy; a Galileo message that
/// tells no accuracy is not. GLONASS's times are UTC: leap seconds are those of the file's header, without it
/// the table's. Throws RinexError.
Navigation read_navigation(const std::vector<std::string>& files);

}  // namespace multipath_localization
