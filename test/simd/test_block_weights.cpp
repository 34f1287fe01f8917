#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "filters/particle_set.hpp"
#include "multipath_localization/core/random.hpp"
#include "simd/block_weights.hpp"
#include "simd/instruction_set.hpp"

namespace multipath_localization {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Whether any particle had weight.
bool set_all(InstructionSet set, const std::vector<double>& logs, BlockWeights& weights) {
  weights.set_equal(logs.size());
  const std::vector<double> ones(kBlockSize, 1.0);
  for (std::size_t block = 0; block < blocks_of(logs.size()); ++block) {
    weights.set(set, block, &logs[block_begin(block)], ones.data());
  }
  return weights.normalise();
}

class BlockWeightsOnEachSet : public ::testing::TestWithParam<InstructionSet> {};

TEST_P(BlockWeightsOnEachSet, GivesTheWeightsOfThePlainReference) {
  for (const std::size_t size : {1U, 255U, 256U, 257U, 5000U}) {
    std::vector<double> logs(size);
    for (std::size_t i = 0; i < size; ++i) {
      logs[i] = 40.0 * RandomStream(1, 0, static_cast<std::uint32_t>(i)).normal() - 1e6;
    }
    BlockWeights weights;
    EXPECT_TRUE(set_all(GetParam(), logs, weights));
    ASSERT_TRUE(normalise(logs));
    const std::vector<double> expected = weights_of(logs);
    double cumulated = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t block = i / kBlockSize;
      cumulated += expected[i];
      EXPECT_NEAR(weights[i], expected[i], 1e-9 * expected[i] + 1e-300);
      EXPECT_NEAR(weights.base(block) + weights.scale(block) * weights.cumulated(block)[i % kBlockSize],
                  cumulated, 1e-9);
    }
    EXPECT_NEAR(weights.total(), 1.0, 1e-12);
    EXPECT_NEAR(weights.effective_sample_size() / effective_sample_size(expected), 1.0, 1e-9);
  }
}

TEST_P(BlockWeightsOnEachSet, TellsWeightsFarBelowTheSmallestDoubleApart) {
  std::vector<double> logs(600, -kInf);
  logs[0] = -1e7;
  logs[599] = -1e7 + std::log(3.0);
  BlockWeights weights;
  EXPECT_TRUE(set_all(GetParam(), logs, weights));
  EXPECT_NEAR(weights[0], 0.25, 1e-9);
  EXPECT_NEAR(weights[599], 0.75, 1e-9);
  EXPECT_EQ(weights[1], 0.0);
  EXPECT_NEAR(weights.log_sum(), -1e7 + std::log(4.0), 1e-6);
}

TEST(BlockWeights, OfNoParticleAreEmpty) {
  BlockWeights weights;
  weights.set_equal(0);
  EXPECT_FALSE(weights.normalise());
  EXPECT_EQ(weights.size(), 0U);
  EXPECT_EQ(weights.total(), 0.0);
}

TEST_P(BlockWeightsOnEachSet, NanIsNoWeightAndNoneAtAllIsEqualWeights) {
  BlockWeights weights;
  EXPECT_TRUE(set_all(GetParam(), {0.0, kNan, 0.0}, weights));
  EXPECT_EQ(weights[1], 0.0);
  EXPECT_NEAR(weights[0], 0.5, 1e-12);
  for (const double excluded : {-kInf, kNan}) {
    EXPECT_FALSE(set_all(GetParam(), std::vector<double>(300, excluded), weights));
    EXPECT_NEAR(weights[299], 1.0 / 300.0, 1e-12);
    EXPECT_NEAR(weights.effective_sample_size(), 300.0, 1e-9);
  }
}

TEST(BlockWeights, AreEqualInEveryBlockAgainWhateverTheyWere) {
  BlockWeights weights;
  for (const std::size_t size : {700U, 256U, 1000U}) {
    std::vector<double> logs(size);
    for (std::size_t i = 0; i < size; ++i) logs[i] = -0.01 * static_cast<double>(i);
    set_all(best_instruction_set(), logs, weights);
    EXPECT_GT(weights[0], weights[size - 1]);
    weights.set_equal(size);
    double sum = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t block = i / kBlockSize;
      sum += weights[i];
      EXPECT_NEAR(weights[i], 1.0 / static_cast<double>(size), 1e-15);
      EXPECT_NEAR(weights.base(block) + weights.scale(block) * weights.cumulated(block)[i % kBlockSize], sum,
                  1e-12);
    }
    EXPECT_NEAR(weights.total(), 1.0, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(All, BlockWeightsOnEachSet,
                         ::testing::Values(InstructionSet::kPlain, best_instruction_set()));

}  // namespace
}  // namespace multipath_localization
