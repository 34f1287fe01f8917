#include <gtest/gtest.h>

#include "models/pseudorange/ionospheric_slant.hpp"

namespace multipath_localization {
namespace {

constexpr double kDegree = kPi / 180.0;

TEST(IonosphericSlant, IsOneAtTheZenithAndTwoOrThreeLowDown) {
  EXPECT_NEAR(ionospheric_slant(90.0 * kDegree), 1.0, 1e-3);
  EXPECT_NEAR(ionospheric_slant(20.0 * kDegree), 2.17, 0.01);
  EXPECT_NEAR(ionospheric_slant(5.0 * kDegree), 3.03, 0.01);
}

TEST(IonosphericSlant, GrowsNoMoreBelowTheHorizon) {
  EXPECT_EQ(ionospheric_slant(-0.3), ionospheric_slant(0.0));
}

}  // namespace
}  // namespace multipath_localization
