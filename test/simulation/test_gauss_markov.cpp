#include <gtest/gtest.h>

#include <cmath>

#include "simulation/gauss_markov.hpp"

namespace multipath_localization {
namespace {

TEST(GaussMarkov2, KeepsItsSigmaAndForgetsWithItsTimeConstant) {
  const int processes = 2000;
  double before = 0.0, after = 0.0, product = 0.0;
  for (std::uint64_t seed = 0; seed < processes; ++seed) {
    GaussMarkov2 process(2.0, 4.0, RandomStream(seed, 0, 1));
    const Eigen::Vector2d first = process.value();
    for (std::uint32_t step = 1; step <= 8; ++step) {
      RandomStream random(seed, step, 1);
      process.step(0.5, random);
    }
    before += 0.5 * first.squaredNorm() / processes;
    after += 0.5 * process.value().squaredNorm() / processes;
    product += 0.5 * first.dot(process.value()) / processes;
  }
  EXPECT_NEAR(before, 4.0, 0.4);  // over 4000 draws, 4.5 sigma
  EXPECT_NEAR(after, 4.0, 0.4);
  EXPECT_NEAR(product / 4.0, std::exp(-1.0), 0.08);
}

TEST(GaussMarkov2, StandsStillWithoutTime) {
  GaussMarkov2 process(2.0, 4.0, RandomStream(1, 0, 1));
  const Eigen::Vector2d first = process.value();
  RandomStream random(1, 1, 1);
  process.step(0.0, random);
  EXPECT_EQ(process.value(), first);
}

}  // namespace
}  // namespace multipath_localization
