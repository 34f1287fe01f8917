#include <gtest/gtest.h>

#include "multipath_localization/models/pseudorange/signal_weights.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

double weight_of(const SatelliteObservation& observation) { return signal_weights({observation}).front(); }

SatelliteObservation overhead() {
  SatelliteObservation observation = satellite(Constellation::kGps, 1, 0.0, 90.0);
  observation.sigma = 2.0;
  return observation;
}

TEST(SignalWeights, AreTheDeclaredOnesOverheadAndStrong) {
  SatelliteObservation observation = overhead();
  EXPECT_NEAR(weight_of(observation), 0.25, 1e-12);
  observation.cn0 = 52.0;
  EXPECT_NEAR(weight_of(observation), 0.25, 1e-12);
  observation.cn0 = SatelliteObservation::kUnknown;
  EXPECT_NEAR(weight_of(observation), 0.25, 1e-12);
}

TEST(SignalWeights, FallTenfoldWithTenDecibelDownToThirty) {
  SatelliteObservation observation = overhead();
  observation.cn0 = 35.0;
  EXPECT_NEAR(weight_of(observation), 0.025, 1e-12);
  observation.cn0 = 15.0;
  EXPECT_NEAR(weight_of(observation), 0.25e-3, 1e-12);
  observation.cn0 = 0.0;
  EXPECT_NEAR(weight_of(observation), 0.25e-3, 1e-12);
}

TEST(SignalWeights, FallTowardsTheHorizonButNotToNothing) {
  SatelliteObservation observation = overhead();
  observation.elevation = kPi / 6.0;
  EXPECT_NEAR(weight_of(observation), 0.25 / 2.5, 1e-12);
  observation.elevation = -0.2;
  EXPECT_GT(weight_of(observation), 1e-3);
}

}  // namespace
}  // namespace multipath_localization
