#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/filters/resampling.hpp"
#include "simd/block_resampling.hpp"

namespace multipath_localization {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

BlockWeights weights_from(InstructionSet set, const std::vector<double>& logs) {
  BlockWeights weights;
  weights.set_equal(logs.size());
  const std::vector<double> ones(kBlockSize, 1.0);
  for (std::size_t block = 0; block < blocks_of(logs.size()); ++block) {
    weights.set(set, block, &logs[block_begin(block)], ones.data());
  }
  weights.normalise();
  return weights;
}

/// How many teeth two combs give to different particles.
int differences(InstructionSet set, const std::vector<double>& logs, std::size_t count, double uniform) {
  const BlockWeights weights = weights_from(set, logs);
  std::vector<double> plain(logs.size());
  for (std::size_t i = 0; i < logs.size(); ++i) plain[i] = weights[i];
  const auto expected = systematic_resampling(plain, count, uniform);
  std::vector<std::uint32_t> ancestors;
  systematic_resampling(set, weights, count, uniform, ancestors);
  EXPECT_EQ(ancestors.size(), count);
  EXPECT_TRUE(std::is_sorted(ancestors.begin(), ancestors.end()));
  int different = 0;
  for (std::size_t k = 0; k < count; ++k) {
    EXPECT_GT(plain[ancestors[k]], 0.0);
    if (ancestors[k] != expected[k]) ++different;
  }
  return different;
}

class BlockResamplingOnEachSet : public ::testing::TestWithParam<InstructionSet> {};

TEST_P(BlockResamplingOnEachSet, DrawsTheAncestorsOfThePlainReference) {
  for (const std::size_t size : {1U, 200U, 256U, 1000U, 5000U}) {
    for (std::uint32_t step = 0; step < 30; ++step) {
      std::vector<double> logs(size);
      for (std::size_t i = 0; i < size; ++i) {
        logs[i] = 3.0 * RandomStream(5, step, static_cast<std::uint32_t>(i)).normal();
      }
      const double uniform = RandomStream(6, step, 0).uniform();
      for (const std::size_t count : {size, 2 * size + 1, size / 3 + 1}) {
        EXPECT_EQ(differences(GetParam(), logs, count, uniform), 0);
      }
    }
  }
}

TEST_P(BlockResamplingOnEachSet, NeverChoosesAParticleWithoutWeight) {
  for (const double uniform : {0.0, 0.3, 1.0 - 1e-16}) {
    std::vector<double> logs(1000, -kInf);
    for (const std::size_t i : {3U, 255U, 256U, 600U}) logs[i] = -0.1 * static_cast<double>(i);
    differences(GetParam(), logs, 777, uniform);  // where the comb touches an edge, rounding decides
    logs.assign(600, -kInf);
    logs[0] = 0.0;
    EXPECT_EQ(differences(GetParam(), logs, 600, uniform), 0);
  }
}

TEST_P(BlockResamplingOnEachSet, EqualWeightsKeepEveryParticle) {
  BlockWeights weights;
  weights.set_equal(1000);
  std::vector<std::uint32_t> ancestors;
  systematic_resampling(GetParam(), weights, 1000, 0.5, ancestors);
  for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(ancestors[i], i);
}

INSTANTIATE_TEST_SUITE_P(All, BlockResamplingOnEachSet,
                         ::testing::Values(InstructionSet::kPlain, best_instruction_set()));

}  // namespace
}  // namespace multipath_localization
