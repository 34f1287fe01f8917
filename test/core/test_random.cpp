#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

using Words = std::array<std::uint32_t, 4>;

/// Vectors published with Random123 (Salmon et al., SC 2011).
TEST(Threefry, GivesThePublishedVectors) {
  EXPECT_EQ(threefry4x32<20>(Words{0, 0, 0, 0}, Words{0, 0, 0, 0}),
            (Words{0x9c6ca96a, 0xe17eae66, 0xfc10ecd4, 0x5256a7d8}));
  const std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(threefry4x32<20>(Words{ones, ones, ones, ones}, Words{ones, ones, ones, ones}),
            (Words{0x2a881696, 0x57012287, 0xf6c7446e, 0xa16a6732}));
  EXPECT_EQ(threefry4x32<20>(Words{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
                             Words{0xa4093822, 0x299f31d0, 0x082efa98, 0xec4e6c89}),
            (Words{0x59cd1dbb, 0xb8879579, 0x86b5d00c, 0xac8b6d84}));
}

TEST(Threefry, OneBitOfInputChangesHalfTheOutput) {
  const Words zero = threefry4x32<12>(Words{}, Words{});
  int flipped = 0;
  for (std::size_t bit = 0; bit < 256; ++bit) {
    Words counter{};
    Words key{};
    (bit < 128 ? counter : key)[bit / 32 % 4] = 1U << (bit % 32);
    const Words one = threefry4x32<12>(counter, key);
    for (std::size_t i = 0; i < 4; ++i) flipped += __builtin_popcount(zero[i] ^ one[i]);
  }
  EXPECT_NEAR(flipped / (256.0 * 128.0), 0.5, 0.015);  // 5 sigma of 32768 fair bits is 0.014
}

TEST(RandomStream, IsAPureFunctionOfSeedStepAndParticle) {
  RandomStream alone(7, 3, 11);
  std::vector<double> expected;
  for (int i = 0; i < 20; ++i) expected.push_back(i % 3 == 0 ? alone.uniform() : alone.normal());
  RandomStream again(7, 3, 11);
  RandomStream other(7, 3, 12);
  for (int i = 0; i < 20; ++i) {
    other.word();
    EXPECT_EQ(i % 3 == 0 ? again.uniform() : again.normal(), expected[static_cast<std::size_t>(i)]);
  }
}

TEST(RandomStream, NormalsAreTheNextOnesInTheirOrder) {
  RandomStream one_by_one(7, 3, 11);
  RandomStream at_once(7, 3, 11);
  const Eigen::Vector3d z = normals<3>(at_once);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(z(i), one_by_one.normal());
  EXPECT_EQ(at_once.normal(), one_by_one.normal());
}

TEST(RandomStream, EveryPartOfItsNameMatters) {
  const std::uint32_t word = RandomStream(1, 2, 3).word();
  EXPECT_NE(RandomStream(2, 2, 3).word(), word);
  EXPECT_NE(RandomStream(1ULL + (1ULL << 40), 2, 3).word(), word);
  EXPECT_NE(RandomStream(1, 3, 3).word(), word);
  EXPECT_NE(RandomStream(1, 2, 4).word(), word);
  EXPECT_NE(RandomStream(1, 3, 2).word(), word);
}

TEST(RandomStream, UniformFillsTheUnitIntervalEvenly) {
  constexpr int kBins = 100;
  constexpr int kDraws = 100000;
  std::vector<int> counts(kBins, 0);
  RandomStream random(1, 0, 0);
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    ++counts[static_cast<std::size_t>(u * kBins)];
  }
  double chi_square = 0.0;
  const double expected = static_cast<double>(kDraws) / kBins;
  for (const int count : counts) chi_square += (count - expected) * (count - expected) / expected;
  EXPECT_GT(chi_square, 45.0);   // 99 degrees of freedom: 0.0005 % of draws fall below,
  EXPECT_LT(chi_square, 175.0);  // 0.0004 % above
}

/// Mean of f over 200 000 normals, each stream giving a few of them.
double mean_over_normals(std::uint64_t seed, const std::function<double(double)>& f) {
  double sum = 0.0;
  for (std::uint32_t particle = 0; particle < 20000; ++particle) {
    RandomStream random(seed, 5, particle);
    for (int i = 0; i < 10; ++i) sum += f(random.normal());
  }
  return sum / 200000.0;
}

TEST(RandomStream, NormalHasTheMomentsOfAStandardNormal) {
  const double sigma =
      1.0 / std::sqrt(200000.0);  // of the mean of something of unit variance; bounds are 4.5 sigma
  EXPECT_NEAR(mean_over_normals(1, [](double x) { return x; }), 0.0, 4.5 * sigma);
  EXPECT_NEAR(mean_over_normals(2, [](double x) { return x * x; }), 1.0, 4.5 * std::sqrt(2.0) * sigma);
  EXPECT_NEAR(mean_over_normals(3, [](double x) { return x * x * x; }), 0.0, 4.5 * std::sqrt(15.0) * sigma);
  EXPECT_NEAR(mean_over_normals(4, [](double x) { return x * x * x * x; }), 3.0,
              4.5 * std::sqrt(96.0) * sigma);
  EXPECT_NEAR(mean_over_normals(5, [](double x) { return std::abs(x) > 1.959964 ? 1.0 : 0.0; }), 0.05,
              4.5 * std::sqrt(0.0475) * sigma);
}

/// Correlation of the normals of streams whose names differ by `step` and `particle`.
double correlation(std::uint32_t step, std::uint32_t particle) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < 50000; ++i) {
    sum += RandomStream(9, i % 100, i / 100).normal() *
           RandomStream(9, i % 100 + step, i / 100 + particle).normal();
  }
  return sum / 50000.0;
}

TEST(RandomStream, NeighbouringStreamsAreIndependent) {
  const double bound = 4.5 / std::sqrt(50000.0);
  EXPECT_NEAR(correlation(1, 0), 0.0, bound);
  EXPECT_NEAR(correlation(0, 1), 0.0, bound);
  EXPECT_NEAR(correlation(1, 1), 0.0, bound);
}

TEST(RandomStream, ThePairThatBoxMullerMakesIsUncorrelated) {
  double product = 0.0;
  double squares = 0.0;
  for (std::uint32_t i = 0; i < 50000; ++i) {
    RandomStream random(3, 0, i);
    const double a = random.normal();
    const double b = random.normal();
    product += a * b;
    squares += (a * a - 1.0) * (b * b - 1.0);
  }
  EXPECT_NEAR(product / 50000.0, 0.0, 4.5 / std::sqrt(50000.0));
  EXPECT_NEAR(squares / 50000.0, 0.0, 4.5 * 2.0 / std::sqrt(50000.0));
}

}  // namespace
}  // namespace multipath_localization
