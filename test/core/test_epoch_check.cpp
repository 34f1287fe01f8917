#include <gtest/gtest.h>

#include <limits>

#include "multipath_localization/core/epoch_check.hpp"

namespace multipath_localization {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

SatelliteObservation sound(int satellite) {
  SatelliteObservation observation;
  observation.satellite = satellite;
  observation.pseudorange = 2.1e7;
  observation.position = {1.2e7, 0.0, 1.7e7};
  return observation;
}

TEST(EpochCheck, KeepsSoundObservationsEvenWithoutSignalStrengthAndDoppler) {
  PseudorangeEpoch epoch;
  epoch.observations = {sound(1), sound(2)};
  EXPECT_EQ(defect(epoch), std::nullopt);
  EXPECT_EQ(usable_observations(epoch).size(), 2u);
}

TEST(EpochCheck, LeavesOutWhatIsNotUsable) {
  std::vector<SatelliteObservation> bad(6, sound(1));
  bad[0].pseudorange = kNan;
  bad[1].elevation = kNan;
  bad[2].sigma = 0.0;
  bad[3].sigma = std::numeric_limits<double>::infinity();
  bad[4].position.setZero();
  bad[5].position.x() = kNan;
  PseudorangeEpoch epoch;
  for (const SatelliteObservation& observation : bad) EXPECT_FALSE(usable(observation));
  epoch.observations = bad;
  EXPECT_EQ(defect(epoch), Reason::kTooFewSatellites);
  epoch.observations.push_back(sound(9));
  EXPECT_EQ(defect(epoch), std::nullopt);
  ASSERT_EQ(usable_observations(epoch).size(), 1u);
  EXPECT_EQ(usable_observations(epoch)[0].satellite, 9);
}

TEST(EpochCheck, TakesEachSatelliteOnce) {
  PseudorangeEpoch epoch;
  epoch.observations = {sound(1), sound(2), sound(1)};
  epoch.observations[2].pseudorange = 2.2e7;
  epoch.observations.push_back(sound(1));
  epoch.observations.back().constellation = Constellation::kGalileo;
  const auto kept = usable_observations(epoch);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[0].pseudorange, 2.1e7);
}

TEST(EpochCheck, RefusesAnEpochThatIsNotFinite) {
  PseudorangeEpoch epoch;
  epoch.observations = {sound(1)};
  epoch.stamp = kNan;
  EXPECT_EQ(defect(epoch), Reason::kNotFinite);
  epoch.stamp = 1.0;
  epoch.antenna_in_base.x() = kNan;
  EXPECT_EQ(defect(epoch), Reason::kNotFinite);
  epoch.antenna_in_base.x() = 1e9;
  EXPECT_EQ(defect(epoch), Reason::kInvalidPosition);
}

}  // namespace
}  // namespace multipath_localization
