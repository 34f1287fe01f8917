#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/filters/resampling.hpp"

namespace multipath_localization {
namespace {

std::vector<double> copies(const std::vector<std::size_t>& ancestors, std::size_t size) {
  std::vector<double> count(size, 0.0);
  for (const std::size_t i : ancestors) count[i] += 1.0;
  return count;
}

TEST(SystematicResampling, IsUnbiased) {
  const std::vector<double> weights = {0.02, 0.4, 0.0, 0.11, 0.13, 0.34};
  constexpr std::size_t kDraws = 7;
  constexpr int kGrid = 100000;  // uniform numbers at the middles of a grid integrate exactly to 1 / kGrid
  std::vector<double> mean(weights.size(), 0.0);
  for (int k = 0; k < kGrid; ++k) {
    const auto count = copies(systematic_resampling(weights, kDraws, (k + 0.5) / kGrid), weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) mean[i] += count[i] / kGrid;
  }
  for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_NEAR(mean[i], kDraws * weights[i], 3.0 / kGrid);
}

TEST(SystematicResampling, IsMonotoneAndRoundsEachShareUpOrDown) {
  for (std::uint32_t step = 0; step < 200; ++step) {
    RandomStream random(5, step, 0);
    std::vector<double> weights(50);
    double total = 0.0;
    for (double& w : weights) total += w = std::exp(3.0 * random.normal());
    const auto ancestors = systematic_resampling(weights, 80, random.uniform());
    ASSERT_EQ(ancestors.size(), 80U);
    EXPECT_TRUE(std::is_sorted(ancestors.begin(), ancestors.end()));
    const auto count = copies(ancestors, weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) {
      EXPECT_LT(std::abs(count[i] - 80.0 * weights[i] / total), 1.0 + 1e-9);
    }
  }
}

TEST(SystematicResampling, EqualWeightsKeepEveryParticle) {
  for (const double uniform : {0.0, 0.5, 1.0 - 1e-16}) {
    const auto ancestors = systematic_resampling(std::vector<double>(1000, 1e-3), 1000, uniform);
    ASSERT_EQ(ancestors.size(), 1000U);
    for (std::size_t i = 0; i < 1000; ++i)
      EXPECT_NEAR(static_cast<double>(ancestors[i]), static_cast<double>(i), 1.0);
  }
}

TEST(SystematicResampling, NeverChoosesAParticleWithoutWeight) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double uniform : {0.0, 0.3, 1.0 - 1e-16}) {
    const auto ancestors = systematic_resampling({0.0, 1e-300, -1.0, 2e-300, nan, 0.0}, 100, uniform);
    ASSERT_EQ(ancestors.size(), 100U);
    for (const std::size_t i : ancestors) EXPECT_TRUE(i == 1 || i == 3);
  }
}

TEST(SystematicResampling, WeightlessSetsCountAsEqual) {
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<std::size_t> all = {0, 1, 2};
  EXPECT_EQ(systematic_resampling({0.0, 0.0, 0.0}, 3, 0.5), all);
  EXPECT_EQ(systematic_resampling({1.0, inf, 1.0}, 3, 0.5), all);
  EXPECT_TRUE(systematic_resampling({}, 3, 0.5).empty());
  EXPECT_TRUE(systematic_resampling({1.0}, 0, 0.5).empty());
}

TEST(Selected, IsTheValueOfEachAncestor) {
  EXPECT_EQ(selected<double>({1.0, 2.0, 3.0}, {0, 2, 2}), (std::vector<double>{1.0, 3.0, 3.0}));
  EXPECT_TRUE(selected<double>({1.0}, {}).empty());
}

}  // namespace
}  // namespace multipath_localization
