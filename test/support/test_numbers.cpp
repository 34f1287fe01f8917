#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/numbers.hpp"

namespace multipath_localization {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Numbers, SquareKeepsNoSign) {
  static_assert(square(-3.0) == 9.0);
  EXPECT_EQ(square(-0.5), 0.25);
}

TEST(Numbers, SumOfLogarithmsIsTheLogarithmOfTheSum) {
  EXPECT_NEAR(log_sum(std::log(2.0), std::log(3.0)), std::log(5.0), 1e-15);
  EXPECT_EQ(log_sum(-1.0, 0.5), log_sum(0.5, -1.0));
}

TEST(Numbers, SumOfLogarithmsNeitherOverflowsNorVanishes) {
  EXPECT_NEAR(log_sum(2000.0, 2000.0), 2000.0 + std::log(2.0), 1e-12);
  EXPECT_NEAR(log_sum(-2000.0, -2000.0), -2000.0 + std::log(2.0), 1e-12);
}

TEST(Numbers, ZeroAddsNothing) {
  EXPECT_EQ(log_sum(-kInfinity, 1.5), 1.5);
  EXPECT_EQ(log_sum(-kInfinity, -kInfinity), -kInfinity);
}

}  // namespace
}  // namespace multipath_localization
