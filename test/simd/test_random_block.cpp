#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "core/threefry.hpp"
#include "instruction_sets.hpp"
#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/random.hpp"
#include "simd/block.hpp"
#include "simd/random_block.hpp"

namespace multipath_localization {
namespace {

TEST(RandomWords, AreThoseOfTheStreamOfEachParticle) {
  constexpr std::uint64_t kSeed = 0x123456789abcdef0U;
  for (const InstructionSet set : instruction_sets()) {
    RandomWords words;
    random_words(set, kSeed, 7, 512, words);
    for (std::uint32_t i = 0; i < kBlockStreams; ++i) {
      RandomStream stream(kSeed, 7, 512 + i);
      for (const auto& word : words.word) ASSERT_EQ(word[i], stream.word());
    }
  }
}

TEST(Threefry, ScheduleEndsWithTheParityOfTheKey) {
  EXPECT_EQ(threefry::schedule({1, 2, 4, 8})[4], 0x1BD11BDAU ^ 15U);
}

/// Box and Muller in plain double precision.
std::pair<double, double> box_muller(std::uint32_t radius, std::uint32_t angle) {
  const double r = std::sqrt(-2.0 * std::log((radius / 2 + 0.5) * 0x1p-31));
  const double turn = kPi * static_cast<std::int32_t>(angle) * 0x1p-31;
  return {r * std::cos(turn), r * std::sin(turn)};
}

TEST(StandardNormals, AreBoxMullersToSinglePrecision) {
  for (const InstructionSet set : instruction_sets()) {
    RandomWords words;
    Normals normals;
    random_words(set, 3, 4, 0, words);
    words.word[0][1] = 0;            // the largest radius
    words.word[0][2] = 0xFFFFFFFFU;  // the smallest
    standard_normals(set, words, normals);
    for (std::size_t i = 0; i < 2 * kBlockStreams; ++i) {
      const std::size_t pair = i / kBlockStreams;
      const std::size_t stream = i % kBlockStreams;
      const auto [a, b] = box_muller(words.word[2 * pair][stream], words.word[2 * pair + 1][stream]);
      const float* normal = &normals.all[2 * pair * kBlockStreams + stream];
      const double bound = i == 2 ? 4e-4 : 2e-6;  // 24 bits leave little of a radius near 0
      EXPECT_NEAR(normal[0], a, bound);
      EXPECT_NEAR(normal[kBlockStreams], b, bound);
    }
  }
}

/// Mean of f over the three normals of 1000 blocks.
double mean_over_normals(const std::function<double(double, double, double)>& f) {
  double sum = 0.0;
  for (std::uint32_t step = 0; step < 1000; ++step) {
    RandomWords words;
    Normals normals;
    random_words(best_instruction_set(), 11, step, 0, words);
    standard_normals(best_instruction_set(), words, normals);
    for (std::size_t i = 0; i < kBlockSize; ++i) {
      sum += f(normals.first()[i], normals.second()[i], normals.third()[i]);
    }
  }
  return sum / (1000.0 * kBlockSize);
}

TEST(StandardNormals, HaveTheMomentsOfIndependentNormals) {
  const double bound =
      4.5 / std::sqrt(1000.0 * kBlockSize);  // 4.5 sigma of the mean of something of unit variance
  EXPECT_NEAR(mean_over_normals([](double a, double, double) { return a; }), 0.0, bound);
  EXPECT_NEAR(mean_over_normals([](double, double, double c) { return c; }), 0.0, bound);
  EXPECT_NEAR(mean_over_normals([](double, double b, double) { return b * b; }), 1.0, bound * std::sqrt(2.0));
  EXPECT_NEAR(mean_over_normals([](double, double, double c) { return c * c * c * c; }), 3.0,
              bound * std::sqrt(96.0));
  EXPECT_NEAR(mean_over_normals([](double a, double b, double) { return a * b; }), 0.0, bound);
  EXPECT_NEAR(mean_over_normals([](double a, double, double c) { return a * c; }), 0.0, bound);
  EXPECT_NEAR(mean_over_normals([](double a, double, double) { return std::abs(a) > 3.0 ? 1.0 : 0.0; }),
              0.0027, bound * std::sqrt(0.0027));
}

/// The normals of two blocks over two steps, one behind the other.
std::vector<double> normals_in_a_row(std::uint64_t seed) {
  std::vector<double> all;
  for (const std::uint32_t step : {6U, 7U}) {
    for (const std::uint32_t first : {0U, static_cast<std::uint32_t>(kBlockSize)}) {
      RandomWords words;
      Normals normals;
      random_words(best_instruction_set(), seed, step, first, words);
      standard_normals(best_instruction_set(), words, normals);
      all.insert(all.end(), normals.all.begin(), normals.all.end());
    }
  }
  return all;
}

TEST(StandardNormals, OfAllParticlesBlocksAndStepsAreIndependent) {
  constexpr std::uint64_t kRuns = 40;
  constexpr std::size_t kLags = 2560;
  std::vector<double> products(kLags, 0.0);
  std::vector<double> products_of_squares(kLags, 0.0);
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    const std::vector<double> x = normals_in_a_row(seed);
    count = x.size();
    for (std::size_t lag = 1; lag < kLags; ++lag) {
      for (std::size_t i = lag; i < count; ++i) {
        const double product = x[i] * x[i - lag];
        products[lag] += product;
        products_of_squares[lag] += product * product - x[i] * x[i] - x[i - lag] * x[i - lag] + 1.0;
      }
    }
  }
  for (std::size_t lag = 1; lag < kLags; ++lag) {
    const double pairs = std::sqrt(static_cast<double>(kRuns * (count - lag)));
    EXPECT_LT(std::abs(products[lag]), 5.0 * pairs) << lag;
    EXPECT_LT(std::abs(products_of_squares[lag]), 6.0 * 2.0 * pairs) << lag;
  }
}

}  // namespace
}  // namespace multipath_localization
