#include <gtest/gtest.h>

#include "multipath_localization/filters/kld_sampling.hpp"

namespace multipath_localization {
namespace {

KldSamplingParameters adaptive() {
  KldSamplingParameters parameters;
  parameters.min_particles = 50;
  parameters.max_particles = 100000;
  return parameters;
}

TEST(KldSampling, NeedsTheChiSquareQuantileOverTwiceTheError) {
  KldSamplingParameters parameters = adaptive();
  parameters.kld_z = 2.326348;  // 99 %
  parameters.kld_err = 0.01;
  EXPECT_NEAR(static_cast<double>(kld_sample_size(11, parameters)), 23.209 / 0.02, 5.0);
  EXPECT_NEAR(static_cast<double>(kld_sample_size(101, parameters)), 135.807 / 0.02, 5.0);
}

TEST(KldSampling, StaysBetweenLeastAndMost) {
  const KldSamplingParameters parameters = adaptive();
  EXPECT_EQ(kld_sample_size(1, parameters), 50U);
  EXPECT_EQ(kld_sample_size(2, parameters), 66U);
  EXPECT_EQ(kld_sample_size(1000000, parameters), 100000U);
}

TEST(KldSampling, OneNumberIsAFixedCount) {
  const KldSamplingParameters parameters;
  for (const std::size_t bins : {1U, 10U, 1000U}) EXPECT_EQ(kld_sample_size(bins, parameters), 1000U);
}

TEST(OccupiedBins, CountsPlacesAndHeadingsOnce) {
  OccupiedBins bins(adaptive());
  bins.add({0.1, 0.1, 0.1});
  bins.add({0.4, 0.2, 0.1});
  EXPECT_EQ(bins.count(), 1U);
  bins.add({-0.1, 0.1, 0.1});
  bins.add({0.1, 0.6, 0.1});
  bins.add({0.1, 0.1, 0.2});
  bins.add({0.1, 0.1, 0.1 + 2.0 * kPi});
  EXPECT_EQ(bins.count(), 4U);
  bins.clear();
  EXPECT_EQ(bins.count(), 0U);
}

}  // namespace
}  // namespace multipath_localization
