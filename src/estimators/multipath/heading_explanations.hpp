#pragma once

#include <optional>

#include "estimators/multipath/heading_block.hpp"
#include "estimators/multipath/hypothesis.hpp"

namespace multipath_localization::multipath {

/// Draws whether headings are outliers, and corrects by them a hypothesis that believes them, equation (23).
/// Returns the logarithm of their density [1/rad].
double explain_heading(Hypothesis& h, const HeadingSighting& z, RandomStream& random);

}  // namespace multipath_localization::multipath
