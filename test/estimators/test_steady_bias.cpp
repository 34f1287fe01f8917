#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/estimators/steady_bias.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector2d kBias(3.0, -4.0);
const SteadyBiasParameters kParameters;

/// Drives on with the bias at 1 m/s, a fix a second.
void drive(SteadyBias& steady, const Eigen::Vector2d& bias, int seconds) {
  for (int i = 0; i < seconds; ++i) steady.add(bias, 1.0, 1.0, kParameters);
}

TEST(SteadyBias, BeginsAtThePriorAndIsEvenAfterTheDistance) {
  SteadyBias steady;
  EXPECT_EQ(steady.probability(kParameters), 0.0) << "there is no bias";
  drive(steady, kBias, 1);
  EXPECT_NEAR(steady.probability(kParameters), kParameters.prior, 0.1 * kParameters.prior);
  drive(steady, kBias, static_cast<int>(kParameters.distance) - 1);
  EXPECT_NEAR(steady.probability(kParameters), 0.5, 1e-6);
  drive(steady, kBias, static_cast<int>(kParameters.distance));
  EXPECT_NEAR(steady.probability(kParameters), 1.0 - kParameters.prior, 0.1 * kParameters.prior);
}

TEST(SteadyBias, NeitherTimeNorDistanceAloneIsEnough) {
  SteadyBias parked, racing;
  for (int i = 0; i < 10000; ++i) parked.add(kBias, 0.0, 1.0, kParameters);
  for (int i = 0; i < 10; ++i) racing.add(kBias, 100.0, 1.0, kParameters);
  EXPECT_EQ(parked.probability(kParameters), 0.0);
  EXPECT_LT(racing.probability(kParameters), 2.0 * kParameters.prior);
}

TEST(SteadyBias, ASpellOfAnotherBiasDelaysAndABiasThatGoesOnChangingIsNone) {
  SteadyBias steady;
  drive(steady, kBias, 100);
  const double before = steady.probability(kParameters);
  drive(steady, 2.0 * kBias, 10);
  EXPECT_LT(steady.probability(kParameters), before);
  drive(steady, kBias, 10);
  EXPECT_NEAR(steady.probability(kParameters), before, 1e-9);

  SteadyBias changing;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 0.05 * i;  // round the circle in two minutes
    changing.add(5.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle)), 1.0, 1.0, kParameters);
    EXPECT_LT(changing.probability(kParameters), 0.02);
  }
}

TEST(SteadyBias, ASmallBiasEndsIt) {
  SteadyBias steady;
  drive(steady, kBias, 100);
  drive(steady, {0.5, 0.5}, 1);
  EXPECT_EQ(steady.probability(kParameters), 0.0);
}

}  // namespace
}  // namespace multipath_localization
