#include <gtest/gtest.h>

#include <algorithm>

#include "rinex/point_positioning.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const Geodetic kAntenna{35.1, 136.9, 100.0};
const GnssTime kTime = on_24_june(8, 20);

class Positioning : public ::testing::Test {
 protected:
  [[nodiscard]] RawEpoch raw(const Geodetic& antenna, double since = 0.0) const {
    return heard(satellites_, antenna, kTime + since, 0.3e-3, 0.0, summer_ionosphere());
  }

  static double off(const std::optional<PointFix>& fix, const Geodetic& antenna) {
    if (!fix) return 1e9;
    const LocalFrame map(antenna);
    return std::hypot(map.to_map(fix->antenna).norm(), fix->antenna.altitude - antenna.altitude);
  }

  /// That every satellite of the epoch stands where it does as seen from there.
  static void expect_seen_from(const Geodetic& antenna, const std::optional<CorrectedEpoch>& epoch) {
    ASSERT_TRUE(epoch);
    ASSERT_FALSE(epoch->satellites.empty());
    const LocalFrame map(antenna);
    for (std::size_t i = 0; i < epoch->satellites.size(); ++i) {
      const Eigen::Vector3d place = map.satellite_to_map(epoch->satellites[i].at_transmission.position);
      EXPECT_NEAR(epoch->observations[i].elevation, direction_of(place).elevation, 1e-6);
    }
  }

  const std::vector<BroadcastOrbit> satellites_ = circling_satellites(Constellation::kGps, 6, 5);
  const Navigation navigation_ = navigation_of(satellites_);
  const PositioningSettings settings_{0.1, {Constellation::kGps}};
};

TEST_F(Positioning, FindsTheAntennaFromNothing) {
  for (const Geodetic& antenna : {kAntenna, Geodetic{-52.0, -60.0, 30.0}, Geodetic{0.1, 179.9, 2500.0}}) {
    PointPositioning positioning(navigation_, settings_);
    const auto epoch = positioning.correct(raw(antenna));
    ASSERT_TRUE(epoch);
    EXPECT_LT(off(epoch->plain, antenna), 1e-3);
    EXPECT_LT(off(epoch->robust, antenna), 1e-3);
  }
}

TEST_F(Positioning, FindsItAgainAfterAJump) {
  PointPositioning positioning(navigation_, settings_);
  ASSERT_TRUE(positioning.correct(raw(kAntenna)));
  const Geodetic elsewhere{36.5, 139.0, 20.0};
  const auto epoch = positioning.correct(raw(elsewhere, 60.0));
  ASSERT_TRUE(epoch);
  EXPECT_LT(off(epoch->robust, elsewhere), 1e-3);
}

TEST_F(Positioning, LeavesOutLowSatellitesAndOtherSystems) {
  const auto all = PointPositioning(navigation_, {0.0, {Constellation::kGps}}).correct(raw(kAntenna));
  const auto high = PointPositioning(navigation_, {0.5, {Constellation::kGps}}).correct(raw(kAntenna));
  ASSERT_TRUE(all && high);
  EXPECT_LT(high->observations.size(), all->observations.size());
  ASSERT_EQ(high->satellites.size(), high->observations.size());
  for (const SatelliteObservation& seen : high->observations) EXPECT_GE(seen.elevation, 0.5);
  EXPECT_FALSE(PointPositioning(navigation_, {0.0, {Constellation::kGalileo}}).correct(raw(kAntenna)));
}

TEST_F(Positioning, AnEpochOfFewSatellitesIsSeenFromTheLastFix) {
  PointPositioning positioning(navigation_, settings_);
  RawEpoch few = raw(kAntenna, 1.0);
  few.observations.resize(2);
  EXPECT_FALSE(positioning.correct(few));
  ASSERT_TRUE(positioning.correct(raw(kAntenna, 2.0)));
  few.time = few.time + 2.0;
  const auto epoch = positioning.correct(few);
  ASSERT_TRUE(epoch);
  EXPECT_FALSE(epoch->plain);
  EXPECT_FALSE(epoch->robust);
}

TEST_F(Positioning, AReflectedSignalBendsTheRobustFixLess) {
  PointPositioning positioning(navigation_, settings_);
  ASSERT_TRUE(positioning.correct(raw(kAntenna)));
  RawEpoch reflected = raw(kAntenna, 1.0);
  reflected.observations[1].pseudorange += 80.0;
  const auto epoch = positioning.correct(reflected);
  ASSERT_TRUE(epoch);
  EXPECT_GT(off(epoch->plain, kAntenna), 8.0);
  EXPECT_LT(off(epoch->robust, kAntenna), 2.0);
}

TEST_F(Positioning, GarbageDoesNotCaptureThePlace) {
  PointPositioning positioning(navigation_, settings_);
  RawEpoch few = raw(kAntenna, 3.0);
  few.observations.resize(2);
  for (const bool known : {false, true}) {
    if (known) positioning.correct(raw(kAntenna));
    RawEpoch garbage = raw(kAntenna, 1.0);
    for (std::size_t i = 0; i < garbage.observations.size(); ++i) {
      garbage.observations[i].pseudorange = 1e5 + 2e7 * static_cast<double>(i % 7);
    }
    positioning.correct(garbage);
    const auto seen = positioning.correct(few);
    EXPECT_EQ(seen.has_value(), known);
    if (known) expect_seen_from(kAntenna, seen);
  }
  const auto epoch = positioning.correct(raw(kAntenna, 4.0));
  ASSERT_TRUE(epoch);
  EXPECT_LT(off(epoch->robust, kAntenna), 0.05);
}

/// Four satellites, one of them below the mask and absurd: they make a cold start, but no robust fix.
TEST_F(Positioning, AnEpochWithoutARobustFixIsSeenFromTheLastPlace) {
  PointPositioning positioning(navigation_, {0.3, {Constellation::kGps}});
  ASSERT_TRUE(positioning.correct(raw(kAntenna)));
  RawEpoch four = raw(kAntenna, 1.0);
  const auto low = [&](const RawObservation& observation) {
    const auto tracked = track(observation, four.time, navigation_.ephemerides);
    const LocalFrame map(kAntenna);
    return direction_of(map.satellite_to_map(tracked->at_transmission.position)).elevation < 0.3;
  };
  std::stable_partition(four.observations.begin(), four.observations.end(), low);
  ASSERT_TRUE(low(four.observations[0]));
  four.observations.erase(std::find_if_not(four.observations.begin() + 1, four.observations.end(), low) + 3,
                          four.observations.end());
  four.observations.erase(four.observations.begin() + 1, four.observations.end() - 3);
  ASSERT_EQ(four.observations.size(), 4u);
  four.observations[0].pseudorange += 2e5;
  const auto epoch = positioning.correct(four);
  EXPECT_EQ(epoch->observations.size(), 3u);
  expect_seen_from(kAntenna, epoch);
}

}  // namespace
}  // namespace multipath_localization
