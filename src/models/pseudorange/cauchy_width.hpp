#pragma once

namespace multipath_localization {

/// Cauchy's weights 1 / (1 + (r / c)^2) of residuals r with this c, in standard deviations, keep 95 % of the
/// efficiency of least squares where errors are normal.
constexpr double kCauchyWidth = 2.385;

}  // namespace multipath_localization
