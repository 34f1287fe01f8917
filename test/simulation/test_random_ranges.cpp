#include <gtest/gtest.h>

#include <array>

#include "simulation/random_ranges.hpp"

namespace multipath_localization {
namespace {

TEST(RandomRanges, DrawsStayWithin) {
  RandomStream random(1, 0, 1);
  for (int i = 0; i < 1000; ++i) {
    const double even = draw(random, Span{-2.0, 3.0});
    EXPECT_GE(even, -2.0);
    EXPECT_LE(even, 3.0);
    const double logarithmic = draw(random, LogSpan{0.01, 10.0});
    EXPECT_GE(logarithmic, 0.01);
    EXPECT_LE(logarithmic, 10.0);
  }
}

TEST(RandomRanges, ALogarithmicDrawIsBelowTheGeometricMeanHalfOfTheTimes) {
  RandomStream random(1, 0, 2);
  int below = 0;
  for (int i = 0; i < 4000; ++i) below += draw(random, LogSpan{0.01, 100.0}) < 1.0 ? 1 : 0;
  EXPECT_NEAR(below, 2000, 130);  // 4 sigma
}

TEST(RandomRanges, ItemsAreAllAsLikely) {
  RandomStream random(1, 0, 3);
  std::array<int, 3> counts{};
  for (int i = 0; i < 3000; ++i) ++counts.at(static_cast<std::size_t>(one_of(random, {0, 1, 2})));
  for (const int count : counts) EXPECT_NEAR(count, 1000, 104);  // 4 sigma
}

}  // namespace
}  // namespace multipath_localization
