#include <gtest/gtest.h>

#include "rinex/tracked_satellite.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const Geodetic kAntenna{35.1, 136.9, 100.0};
const GnssTime kTime = on_24_june(8, 20);
constexpr double kClock = 0.4e-3;
constexpr double kDrift = 1e-7;

class Track : public ::testing::Test {
 protected:
  const std::vector<BroadcastOrbit> satellites_ = circling_satellites(Constellation::kGps, 6, 4);
  const Navigation navigation_ = navigation_of(satellites_);
  const RawEpoch raw_ = heard(satellites_, kAntenna, kTime, kClock, kDrift, summer_ionosphere());
  const LocalFrame map_{kAntenna};
};

TEST_F(Track, WhatIsLeftOfAPseudorangeIsRangeAndReceiverClock) {
  ASSERT_GE(raw_.observations.size(), 6u);
  for (const RawObservation& raw : raw_.observations) {
    const auto tracked = track(raw, raw_.time, navigation_.ephemerides);
    ASSERT_TRUE(tracked);
    const SatelliteObservation seen = seen_from(map_, *tracked, raw_.time, navigation_.ionosphere);
    EXPECT_EQ(seen.satellite, raw.satellite.number);
    EXPECT_NEAR(seen.pseudorange - seen.position.norm(), kSpeedOfLight * kClock, 1e-3);
    const double rate = seen.position.normalized().dot(seen.velocity);
    // The range changes by a second of transmission and is measured by one of reception: rate^2 / c.
    EXPECT_NEAR(seen.range_rate - rate, kSpeedOfLight * kDrift, 3e-3);
    EXPECT_DOUBLE_EQ(seen.elevation, direction_of(seen.position).elevation);
    EXPECT_DOUBLE_EQ(seen.cn0, 45.0);
    EXPECT_DOUBLE_EQ(seen.sigma, pseudorange_sigma(seen.elevation, 45.0));
    const SatelliteObservation without = seen_from(map_, *tracked, raw_.time, std::nullopt);
    EXPECT_GT(without.pseudorange - seen.pseudorange, 1.0);
  }
}

TEST_F(Track, TheIonosphereDelaysLowerFrequenciesMore) {
  TrackedSatellite tracked = *track(raw_.observations[0], raw_.time, navigation_.ephemerides);
  const auto delay = [&] {
    return seen_from(map_, tracked, raw_.time, std::nullopt).pseudorange -
           seen_from(map_, tracked, raw_.time, navigation_.ionosphere).pseudorange;
  };
  const double at_l1 = delay();
  tracked.frequency /= 2.0;
  EXPECT_NEAR(delay() / at_l1, 4.0, 1e-6);
}

TEST_F(Track, RefusesFlightsOfNoLength) {
  RawObservation raw = raw_.observations[0];
  for (const double pseudorange : {0.0, -2e7, 3e8, 1e300}) {
    raw.pseudorange = pseudorange;
    EXPECT_FALSE(track(raw, raw_.time, navigation_.ephemerides)) << pseudorange;
  }
  raw = raw_.observations[0];
  raw.satellite.number = 99;
  EXPECT_FALSE(track(raw, raw_.time, navigation_.ephemerides));
}

TEST_F(Track, RefusesAnOrbitThatIsNotFinite) {
  BroadcastOrbit orbit = satellites_[0];
  orbit.inclination_rate = 1e308;
  Ephemerides ephemerides;
  ephemerides.add(orbit);
  RawObservation raw;
  raw.satellite = orbit.satellite;
  raw.pseudorange = 2.2e7;
  EXPECT_FALSE(track(raw, kTime, ephemerides));
}

TEST_F(Track, RefusesClocksThatNoSatelliteHas) {
  RawObservation raw;
  raw.satellite = satellites_[0].satellite;
  raw.pseudorange = 2.2e7;
  const auto tracks = [&](const Ephemeris& ephemeris) {
    Ephemerides ephemerides;
    ephemerides.add(ephemeris);
    return track(raw, kTime, ephemerides).has_value();
  };
  const auto with_clock = [&](const Eigen::Vector3d& polynomial, double age) {
    BroadcastOrbit orbit = satellites_[0];
    orbit.clock_polynomial = polynomial;
    orbit.clock_reference = orbit.reference + -age;
    return tracks(orbit);
  };
  EXPECT_TRUE(with_clock({0.09, -9e-7, 9e-13}, 86400.0));
  EXPECT_FALSE(with_clock({0.0, 0.0, 0.0}, 86401.0));
  for (const double hostile : {0.2, 1e9, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(with_clock(hostile * Eigen::Vector3d::Unit(i), 0.0)) << hostile;
  }
  GlonassOrbit glonass = orbit_of<GlonassOrbit>(kGlonass1At815, {Constellation::kGlonass, 1}, kTime);
  raw.satellite = glonass.satellite;
  EXPECT_TRUE(tracks(glonass));
  glonass.clock = 1e300;
  EXPECT_FALSE(tracks(glonass));
}

TEST_F(Track, WithoutDopplerThereIsNoRangeRate) {
  RawObservation raw = raw_.observations[0];
  raw.doppler = SatelliteObservation::kUnknown;
  EXPECT_TRUE(std::isnan(track(raw, raw_.time, navigation_.ephemerides)->range_rate));
}

TEST(PseudorangeSigma, IsItsModel) {
  const double degree = kPi / 180.0;
  EXPECT_NEAR(pseudorange_sigma(90.0 * degree, 45.0), std::hypot(0.8, 1.0), 1e-12);
  EXPECT_NEAR(pseudorange_sigma(30.0 * degree, 35.0), std::hypot(1.6, std::sqrt(10.0)), 1e-12);
  EXPECT_DOUBLE_EQ(pseudorange_sigma(0.5, SatelliteObservation::kUnknown), pseudorange_sigma(0.5, 38.0));
  EXPECT_DOUBLE_EQ(pseudorange_sigma(-1.0, 40.0), pseudorange_sigma(3.0 * degree, 40.0));
}

}  // namespace
}  // namespace multipath_localization
