#pragma once

#include <optional>

#include "estimators/multipath/hypothesis.hpp"
#include "estimators/multipath/velocity_block.hpp"

namespace multipath_localization::multipath {

/// Explains velocities by their law or as reflected, drawn by prior times likelihood, equation (19), and
/// corrects a hypothesis that believes them. One whose heading is any takes it from their course, equation
/// (20). Returns the logarithm of their probability density [s^2/m^2]; nothing where the wheels fail, of
/// which any velocity is as probable.
std::optional<double> explain_velocity(Hypothesis& hypothesis, const VelocitySighting& sighting,
                                       RandomStream& random);

}  // namespace multipath_localization::multipath
