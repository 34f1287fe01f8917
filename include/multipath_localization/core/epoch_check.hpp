#pragma once

#include <optional>
#include <vector>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What makes a whole epoch unusable, or nothing:
/// - kNotFinite: NaN or infinity in stamp or lever arm;
/// - kInvalidPosition: a lever arm of 1e8 m or more;
/// - kTooFewSatellites: no usable observation.
std::optional<Reason> defect(const PseudorangeEpoch& epoch);

/// True for finite pseudorange and elevation, a positive finite sigma and a satellite between 1e7 and 1e8 m
/// away from the origin of map. C/N0 and Doppler may be missing.
bool usable(const SatelliteObservation& observation);

/// The usable observations, each satellite once: of several with one name the first counts.
std::vector<SatelliteObservation> usable_observations(const PseudorangeEpoch& epoch);

}  // namespace multipath_localization
