#pragma once

#include <cstdint>

#include "evaluation/drive.hpp"
#include "simulation/faults.hpp"

namespace multipath_localization {

/// The recording as it would have been with these faults between the sensors and whoever recorded them; zones
/// lie in the drive's map. A fix that claims status -1 is left out, as no reader takes it. Pairs of fixes and
/// epochs stay as they are. Deterministic by seed.
Drive spoilt(const Drive& drive, const FaultParameters& faults, std::uint64_t seed);

}  // namespace multipath_localization
