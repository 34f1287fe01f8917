#pragma once

#include <string>
#include <vector>

#include "multipath_localization/core/constellation.hpp"

namespace multipath_localization {

/// Codes of pseudoranges on L1, E1, G1, B1I and B1C, all that RINEX 3.05 has, in the order in which they are
/// taken: GPS C1C C1X C1L C1S C1P C1W C1Y C1M; GLONASS C1C C1P; Galileo C1C C1X C1B C1Z C1A; BeiDou, B1I
/// first, C2I C2X C2Q C1I C1P C1X C1D C1Q C1S C1L C1Z; QZSS C1C C1X C1L C1S C1E C1Z C1B; in version 2
/// C1 CA P1 CB, of BeiDou C2.
std::vector<std::string> pseudorange_codes(Constellation constellation, double version);

/// Whether a code of BeiDou is of B1C or B1A, whose carrier is that of L1, and not of B1I.
bool on_b1c(const std::string& code, double version);

}  // namespace multipath_localization
