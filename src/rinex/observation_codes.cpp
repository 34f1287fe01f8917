#include "rinex/observation_codes.hpp"

#include <cmath>

namespace multipath_localization {

std::vector<std::string> pseudorange_codes(Constellation constellation, double version) {
  const bool beidou = constellation == Constellation::kBeidou;
  if (version < 3.0 && beidou) return {"C2"};
  if (version < 3.0) return {"C1", "CA", "P1", "CB"};
  switch (constellation) {
    case Constellation::kGps: return {"C1C", "C1X", "C1L", "C1S", "C1P", "C1W", "C1Y", "C1M"};
    case Constellation::kGlonass: return {"C1C", "C1P"};
    case Constellation::kGalileo: return {"C1C", "C1X", "C1B", "C1Z", "C1A"};
    case Constellation::kBeidou:
      return {"C2I", "C2X", "C2Q", "C1I", "C1P", "C1X", "C1D", "C1Q", "C1S", "C1L", "C1Z"};
    case Constellation::kQzss: return {"C1C", "C1X", "C1L", "C1S", "C1E", "C1Z", "C1B"};
  }
  return {};
}

bool on_b1c(const std::string& code, double version) {
  if (version < 3.0 || code[1] != '1' || code[2] == 'I' || code[2] == 'Q') return false;
  // Version 3.02 alone numbers B1I's band 1.
  return code[2] != 'X' || std::abs(version - 3.02) > 0.005;
}

}  // namespace multipath_localization
