#pragma once

#include <cstdint>

#include "simulation/faults.hpp"

namespace multipath_localization {

/// Faults of every kind at random, for so many hours: each kind some three times an hour, minutes long.
FaultParameters random_faults(double hours, std::uint64_t seed);

}  // namespace multipath_localization
