#pragma once

#include <optional>
#include <vector>

#include "multipath_localization/models/pseudorange/pseudorange.hpp"

namespace multipath_localization {

/// Single point positioning that outliers bend less: `solve_position` again and again, the declared weight of
/// each observation divided by 1 + (r / c)^2 of its last residual r (Cauchy's weights), c = kCauchyWidth
/// declared standard deviations, or of such as the residuals' median has them where that is more. The
/// solution is that of the last weights; so are its covariance and its sum of squares. Nothing where
/// `solve_position` finds nothing.
std::optional<PseudorangeSolution> robust_position(const std::vector<SatelliteObservation>& observations,
                                                   const Eigen::Vector3d& start);

/// What is left of each pseudorange without range and clock [m].
std::vector<double> residuals(const std::vector<SatelliteObservation>& observations,
                              const PseudorangeSolution& solution);

}  // namespace multipath_localization
