#include <gtest/gtest.h>

#include <cmath>

#include "estimators/pseudorange_mixture/error_scales.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

TEST(ErrorScales, FindTheSizeOfErrorsThroughOutliers) {
  ErrorScales scales;
  RandomStream random(11, 0, 0);
  for (int i = 0; i < 20000; ++i) {
    const double error = 0.4 * random.normal() + (i % 10 == 0 ? 20.0 : 0.0);
    scales.learn_rate(error / scales.rate, 1.0);
    scales.learn_range(5.0 * error / scales.range, 1.0);
  }
  EXPECT_NEAR(scales.rate, 0.45, 0.08);
  EXPECT_NEAR(scales.range, 2.25, 0.4);
}

TEST(ErrorScales, BiasesTellTheirSizeAsFarAsTheyAreMany) {
  ErrorScales few;
  ErrorScales many;
  for (int i = 0; i < 600; ++i) {
    few.learn_bias(4.0 * 1.0, 1.0, 1.0);
    many.learn_bias(4.0 * 20.0, 20.0, 1.0);
  }
  EXPECT_NEAR(few.bias, std::sqrt(8.0 / 5.0), 1e-3);
  EXPECT_NEAR(many.bias, std::sqrt(84.0 / 24.0), 1e-3);
}

}  // namespace
}  // namespace multipath_localization
