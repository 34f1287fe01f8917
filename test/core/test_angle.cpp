#include <gtest/gtest.h>

#include <limits>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {
namespace {

TEST(Angle, WrappingKeepsTheDirectionAndLandsInTheHalfOpenInterval) {
  for (int i = -200; i <= 200; ++i) {
    const double angle = 0.37 * i;
    const double wrapped = wrap_angle(angle);
    EXPECT_GT(wrapped, -kPi);
    EXPECT_LE(wrapped, kPi);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
  }
}

TEST(Angle, OppositeDirectionIsPlusPi) {
  EXPECT_EQ(wrap_angle(kPi), kPi);
  EXPECT_EQ(wrap_angle(-kPi), kPi);
  EXPECT_EQ(wrap_angle(3.0 * kPi), kPi);
  EXPECT_EQ(wrap_angle(-3.0 * kPi), kPi);
  EXPECT_LT(wrap_angle(std::nextafter(kPi, 4.0)), 0.0);
}

TEST(Angle, SmallestTurnCrossesTheSeam) {
  EXPECT_NEAR(angle_difference(-kPi + 0.1, kPi - 0.1), 0.2, 1e-12);
  EXPECT_NEAR(angle_difference(kPi - 0.1, -kPi + 0.1), -0.2, 1e-12);
  EXPECT_EQ(angle_difference(kPi, 0.0), kPi);
  EXPECT_EQ(angle_difference(-kPi, 0.0), kPi);
}

TEST(Angle, NotFiniteGivesNan) {
  EXPECT_TRUE(std::isnan(wrap_angle(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(wrap_angle(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isfinite(wrap_angle(1e308)));
}

}  // namespace
}  // namespace multipath_localization
