#include <gtest/gtest.h>

#include "multipath_localization/core/angle.hpp"
#include "simulation/code_multipath.hpp"

namespace multipath_localization {
namespace {

constexpr double kNarrow = 0.1;   // [chip]
constexpr double kChip = 293.05;  // [m]
constexpr double kHalf = 0.5 * kNarrow * kChip;

TEST(CodeMultipath, ANearEchoPullsTheCodeByItsShare) {
  EXPECT_NEAR(code_multipath({0.5, 6.0, 0.0}, kNarrow), 0.5 * 6.0 / 1.5, 1e-9);
  EXPECT_NEAR(code_multipath({0.5, 6.0, kPi}, kNarrow), -0.5 * 6.0 / 0.5, 1e-9);
  EXPECT_NEAR(code_multipath({0.5, 6.0, 0.5 * kPi}, kNarrow), 0.0, 1e-9);
}

TEST(CodeMultipath, AnEarlierEchoPullsTheOtherWay) {
  EXPECT_DOUBLE_EQ(code_multipath({0.3, -9.0, 1.0}, kNarrow), -code_multipath({0.3, 9.0, 1.0}, kNarrow));
}

TEST(CodeMultipath, AFarEchoIsHeldByTheSpacing) {
  EXPECT_NEAR(code_multipath({0.5, 100.0, 0.0}, kNarrow), 0.5 * kHalf, 1e-9);
  EXPECT_NEAR(code_multipath({0.5, 100.0, kPi}, kNarrow), -0.5 * kHalf, 1e-9);
  EXPECT_NEAR(code_multipath({0.5, 100.0, 0.0}, 2.0 * kNarrow), kHalf, 1e-9);
}

TEST(CodeMultipath, BeyondAChipNoEchoCounts) {
  EXPECT_NEAR(code_multipath({0.5, kChip, 0.0}, kNarrow), 0.25 * kHalf, 1e-9);  // half way out
  EXPECT_NEAR(code_multipath({0.5, kChip + kHalf, 0.0}, kNarrow), 0.0, 1e-9);
  EXPECT_EQ(code_multipath({0.5, 2.0 * kChip, 0.0}, kNarrow), 0.0);
}

TEST(CodeMultipath, NoEchoNoError) { EXPECT_EQ(code_multipath({0.0, 50.0, 0.0}, kNarrow), 0.0); }

}  // namespace
}  // namespace multipath_localization
