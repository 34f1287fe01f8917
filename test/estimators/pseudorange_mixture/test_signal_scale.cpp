#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "estimators/pseudorange_mixture/signal_scale.hpp"

namespace multipath_localization {
namespace {

std::vector<SatelliteObservation> heard(std::initializer_list<double> all) {
  std::vector<SatelliteObservation> observations;
  for (const double cn0 : all) {
    observations.emplace_back();
    observations.back().cn0 = cn0;
  }
  return observations;
}

TEST(SignalScale, KnowsNothingBeforeAnySignal) {
  SignalScale scale;
  EXPECT_TRUE(std::isnan(scale.strong()));
  scale.add(heard({std::numeric_limits<double>::quiet_NaN()}), 1.0);
  EXPECT_TRUE(std::isnan(scale.strong()));
}

TEST(SignalScale, IsWhatOneSignalInTenExceeds) {
  SignalScale scale;
  for (int i = 0; i < 100; ++i) {
    scale.add(heard({20.0, 21.0, 22.0, 23.0, 24.0, 25.0, 26.0, 27.0, 43.5, 50.0}), 0.2);
  }
  EXPECT_NEAR(scale.strong(), 44.0, 0.01);
}

TEST(SignalScale, StaysWithinItsScaleWhateverIsDeclared) {
  SignalScale scale;
  scale.add(heard({-300.0}), 1.0);
  EXPECT_NEAR(scale.strong(), 0.5, 0.51);
  scale.add(heard({1e9, 1e9, 1e9}), 1.0);
  EXPECT_NEAR(scale.strong(), 63.5, 0.51);
}

TEST(SignalScale, ForgetsAnotherAntenna) {
  SignalScale scale;
  for (int i = 0; i < 600; ++i) scale.add(heard({45.0}), 1.0);
  scale.add(heard({30.0}), 1.0);
  EXPECT_NEAR(scale.strong(), 45.5, 0.51);
  for (int i = 0; i < 1200; ++i) scale.add(heard({30.0}), 1.0);
  EXPECT_NEAR(scale.strong(), 30.5, 0.51);
}

}  // namespace
}  // namespace multipath_localization
