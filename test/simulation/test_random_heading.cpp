#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "simulation/random_heading.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {
namespace {

constexpr std::uint64_t kSeeds = 40;

TEST(RandomHeading, IsOffByWhatWasDrawnAndAnyAsOften) {
  const std::vector<MotionStep> steps(60000, {{0.0, 0.0, 3.0}, 2.0, 0.0});
  double off = 0.0, drawn = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const RandomHeading heading = draw_heading(seed);
    const double sigma = std::hypot(heading.white_sigma, heading.slow_sigma);
    double far = 0.0, squares = 0.0, near = 0.0, all = 0.0;
    for (const Heading& told : read_headings(heading, steps, seed)) {
      const double error = angle_difference(told.yaw, 3.0 + heading.offset);
      const bool any = std::abs(error) > 5.0 * sigma;
      (any ? far : near) += 1.0;
      squares += any ? 0.0 : square(error);
      all += 1.0;
    }
    EXPECT_NEAR(std::sqrt(squares / near), sigma, 0.5 * sigma) << seed;
    off += far / all / kSeeds;
    drawn += heading.outlier_share / kSeeds;
  }
  EXPECT_LT(off, 1.1 * drawn);
  EXPECT_GT(off, 0.5 * drawn);
}

TEST(RandomHeading, IsTheSameForTheSameSeed) {
  const std::vector<MotionStep> steps(1000, {{0.0, 0.0, 3.0}, 2.0, 0.0});
  const auto once = read_headings(draw_heading(7), steps, 7);
  const auto again = read_headings(draw_heading(7), steps, 7);
  ASSERT_EQ(once.size(), again.size());
  ASSERT_FALSE(once.empty());
  EXPECT_EQ(once.back().yaw, again.back().yaw);
  EXPECT_NE(once.back().yaw, read_headings(draw_heading(8), steps, 8).back().yaw);
}

}  // namespace
}  // namespace multipath_localization
