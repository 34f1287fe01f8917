#include <gtest/gtest.h>

#include <cmath>

#include "models/pseudorange/cauchy_width.hpp"
#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {
namespace {

/// The asymptotic efficiency of an M-estimator of influence psi where errors are standard normal is
/// E[psi']^2 / E[psi^2]; here psi(r) = r / (1 + (r / c)^2).
TEST(CauchyWidth, KeepsNinetyFivePercentOfTheEfficiency) {
  constexpr double kStep = 1e-3;
  double slope = 0.0;
  double square = 0.0;
  for (double r = -10.0; r < 10.0; r += kStep) {
    const double density = std::exp(-0.5 * r * r) / std::sqrt(2.0 * kPi);
    const double ratio = r * r / (kCauchyWidth * kCauchyWidth);
    slope += kStep * density * (1.0 - ratio) / ((1.0 + ratio) * (1.0 + ratio));
    square += kStep * density * r * r / ((1.0 + ratio) * (1.0 + ratio));
  }
  EXPECT_NEAR(slope * slope / square, 0.95, 1e-3);
}

}  // namespace
}  // namespace multipath_localization
