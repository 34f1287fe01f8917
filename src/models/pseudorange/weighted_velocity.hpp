#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// Velocity of the antenna in map, east, north, up [m/s], v of Eq. (8) of [SUZ]: weighted least squares of
/// the range rates over velocity and clock drift. `directions` to the satellites are of length 1, one weight
/// >= 0 per observation (only their ratios count); observations without Doppler are left out, and those
/// that even a clock off by 33 ppm would not explain. Nothing with
/// fewer than four, when their geometry leaves a component undetermined or above 200 m/s.
///
/// With a `tolerance` above 0 [m/s] it is solved twice more, each range rate weighted by a Cauchy kernel of
/// that width: a reflected signal comes from elsewhere and has another Doppler. Departs: [SUZ] has none.
std::optional<Eigen::Vector3d> weighted_velocity(const std::vector<SatelliteObservation>& observations,
                                                 const std::vector<Eigen::Vector3d>& directions,
                                                 const std::vector<double>& weights, double tolerance);

}  // namespace multipath_localization
