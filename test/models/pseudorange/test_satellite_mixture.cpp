#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/pseudorange/satellite_mixture.hpp"

namespace multipath_localization {
namespace {

const SatelliteMixtureParameters kParameters;

SatelliteObservation observation(double cn0, double elevation) {
  SatelliteObservation result;
  result.cn0 = cn0;
  result.elevation = elevation;
  return result;
}

double gaussian(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (sigma * std::sqrt(2.0 * kPi));
}

TEST(ExponentiallyModifiedGaussian, IsADensityWithTheDelayAsItsMean) {
  for (const double sigma : {0.5, 3.0, 30.0}) {
    double mass = 0.0;
    double mean = 0.0;
    const double step = 0.05;
    for (double e = -300.0; e < 1200.0; e += step) {
      const double p = step * std::exp(log_exponentially_modified_gaussian(e, sigma, 40.0));
      mass += p;
      mean += p * e;
    }
    EXPECT_NEAR(mass, 1.0, 1e-6);
    EXPECT_NEAR(mean, 40.0, 1e-3);
  }
}

TEST(ExponentiallyModifiedGaussian, IsTheConvolutionOfItsTwoParts) {
  const double sigma = 4.0;
  const double delay = 25.0;
  for (const double e : {-15.0, -3.0, 0.0, 5.0, 40.0, 150.0}) {
    double sum = 0.0;
    const double step = 0.01;
    for (double d = 0.5 * step; d < 600.0; d += step) {
      sum += step * gaussian(e - d, sigma) * std::exp(-d / delay) / delay;
    }
    EXPECT_NEAR(std::exp(log_exponentially_modified_gaussian(e, sigma, delay)) / sum, 1.0, 1e-4);
  }
}

TEST(ExponentiallyModifiedGaussian, IsFiniteAndMonotonicInBothFarTails) {
  double last = log_exponentially_modified_gaussian(-1e6, 2.0, 40.0);
  EXPECT_TRUE(std::isfinite(last));
  for (double e = -1e6; e < -1.0; e *= 0.9) {
    const double next = log_exponentially_modified_gaussian(0.9 * e, 2.0, 40.0);
    EXPECT_GT(next, last);
    last = next;
  }
  const double slope = log_exponentially_modified_gaussian(2000.0, 2.0, 40.0) -
                       log_exponentially_modified_gaussian(1000.0, 2.0, 40.0);
  EXPECT_NEAR(slope, -1000.0 / 40.0, 1e-6);
}

TEST(LineOfSightPrior, RisesWithCn0AndElevation) {
  double last = 0.0;
  for (const double cn0 : {-12.0, -10.0, -8.0, -6.0}) {
    const double prior = line_of_sight_prior(observation(cn0, 0.6), kParameters);
    EXPECT_GT(prior, last);
    EXPECT_GT(line_of_sight_prior(observation(cn0, 1.2), kParameters), prior);
    last = prior;
  }
  EXPECT_NEAR(line_of_sight_prior(observation(kParameters.cn0_midpoint, kPi / 6.0), kParameters), 0.5, 1e-9);
}

TEST(LineOfSightPrior, IsNeverCertainAndTakesAnUntoldCn0) {
  EXPECT_GT(line_of_sight_prior(observation(-60.0, 0.0), kParameters), 0.0);
  EXPECT_LT(line_of_sight_prior(observation(99.0, 1.5), kParameters), 1.0);
  EXPECT_NEAR(line_of_sight_prior(observation(SatelliteObservation::kUnknown, kPi / 6.0), kParameters), 0.5,
              1e-9);
}

TEST(MeanNlosDelay, FallsWithTheElevationAndStaysPositive) {
  EXPECT_NEAR(mean_nlos_delay(0.0, kParameters), kParameters.nlos_delay, 1e-9);
  EXPECT_NEAR(mean_nlos_delay(kPi / 3.0, kParameters), 0.5 * kParameters.nlos_delay, 1e-9);
  EXPECT_GT(mean_nlos_delay(kPi / 2.0, kParameters), 1.0);
}

TEST(Weigh, FollowsBayes) {
  for (const double error : {-8.0, 0.0, 3.0, 12.0, 60.0}) {
    const MixtureWeight weight = weigh(error, 9.0, 40.0, 0.3);
    const double odds = 0.3 / 0.7 * std::exp(weight.log_ratio);
    EXPECT_NEAR(weight.line_of_sight, odds / (1.0 + odds), 1e-9);
    const double late = std::exp(log_exponentially_modified_gaussian(error, 3.0, 40.0));
    EXPECT_NEAR(std::exp(weight.log_likelihood), 0.3 * gaussian(error, 3.0) + 0.7 * late, 1e-6);
  }
}

TEST(Weigh, TellsALateSignalFromADirectOne) {
  EXPECT_GT(weigh(0.0, 9.0, 40.0, 0.5).line_of_sight, 0.8);
  EXPECT_LT(weigh(40.0, 9.0, 40.0, 0.5).line_of_sight, 1e-6);
  // No reflection is early.
  EXPECT_GT(weigh(-7.0, 9.0, 40.0, 0.5).line_of_sight, 0.8);
}

TEST(Weigh, IsFiniteHoweverFarOff) {
  for (const double error : {-1e6, -1e3, 1e3, 3e5, 1e7}) {
    const MixtureWeight weight = weigh(error, 4.0, 40.0, 0.9);
    EXPECT_TRUE(std::isfinite(weight.log_likelihood));
    EXPECT_TRUE(std::isfinite(weight.log_ratio));
    EXPECT_LT(weight.line_of_sight, 1e-9);
  }
}

}  // namespace
}  // namespace multipath_localization
