#pragma once

#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// Weights that trust weak and low signals less than their declared standard deviations do [1/m^2]: the
/// variance is sigma^2 (1 + 1 / sin^2(elevation)) / 2, ten times as much for every 10 dB that C/N0 lies below
/// 45 dB-Hz, down to 15: signals off a wall are weak. Where C/N0 is not told it counts as 45 dB-Hz.
std::vector<double> signal_weights(const std::vector<SatelliteObservation>& observations);

}  // namespace multipath_localization
