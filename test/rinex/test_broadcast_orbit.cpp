#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "broadcast.hpp"
#include "multipath_localization/core/angle.hpp"
#include "rinex/broadcast_orbit.hpp"

namespace multipath_localization {
namespace {

const SatelliteId kG05{Constellation::kGps, 5};
const SatelliteId kE12{Constellation::kGalileo, 12};
const SatelliteId kC01{Constellation::kBeidou, 1};

/// An orbit of no corrections, its Kepler elements at hand.
BroadcastOrbit plain_orbit(double eccentricity, double mean_anomaly) {
  BroadcastOrbit orbit;
  orbit.satellite = kG05;
  orbit.reference = {2320, 7200.0};
  orbit.clock_reference = orbit.reference;
  orbit.toe = 7200.0;
  orbit.root_axis = 5153.6;
  orbit.eccentricity = eccentricity;
  orbit.inclination = 0.96;
  orbit.node = 2.0;
  orbit.perigee = 0.7;
  orbit.mean_anomaly = mean_anomaly;
  return orbit;
}

TEST(BroadcastOrbit, OnACircleIsThatOfSphericalTrigonometry) {
  const BroadcastOrbit orbit = plain_orbit(0.0, 0.3);
  const SatelliteState state = satellite_state(orbit, orbit.reference);
  const double radius = orbit.root_axis * orbit.root_axis;
  const double u = 0.7 + 0.3;
  EXPECT_NEAR(state.position.norm(), radius, 1e-6);
  EXPECT_NEAR(state.position.z(), radius * std::sin(u) * std::sin(0.96), 1e-6);
  const double longitude =
      std::atan2(std::cos(0.96) * std::sin(u), std::cos(u)) + 2.0 - 7200.0 * kEarthRotationRate;
  EXPECT_NEAR(angle_difference(std::atan2(state.position.y(), state.position.x()), longitude), 0.0, 1e-12);
}

TEST(BroadcastOrbit, KeepsKeplersLaws) {
  const double axis = 5153.6 * 5153.6;
  const double period = 2.0 * kPi * std::sqrt(axis * axis * axis / 3.986005e14);
  const BroadcastOrbit orbit = plain_orbit(0.02, 0.0);
  EXPECT_NEAR(satellite_state(orbit, orbit.reference).position.norm(), axis * 0.98, 1e-6);
  EXPECT_NEAR(satellite_state(orbit, orbit.reference + 0.5 * period).position.norm(), axis * 1.02, 1e-5);
  // In a frame that does not turn, the area swept per second is that of the ellipse over its period.
  for (const double time : {0.1 * period, 0.37 * period, 0.8 * period}) {
    const SatelliteState state = satellite_state(orbit, orbit.reference + time);
    const Eigen::Vector3d velocity =
        state.velocity + kEarthRotationRate * Eigen::Vector3d::UnitZ().cross(state.position);
    const double area = kPi * axis * axis * std::sqrt(1.0 - 0.02 * 0.02);
    EXPECT_NEAR(0.5 * state.position.cross(velocity).norm() / (area / period), 1.0, 1e-12);
  }
}

TEST(BroadcastOrbit, VelocityAndDriftAreDerivatives) {
  const GnssTime time = on_24_june(8, 20);
  const BroadcastOrbit geostationary_one = orbit_of<BroadcastOrbit>(kBeidou1, kC01, time);
  BroadcastOrbit medium = geostationary_one;
  medium.satellite.number = 30;
  for (const BroadcastOrbit& orbit :
       {orbit_of<BroadcastOrbit>(kGps5, kG05, time), orbit_of<BroadcastOrbit>(kGalileo12At8, kE12, time),
        geostationary_one, medium}) {
    const SatelliteState state = satellite_state(orbit, time);
    EXPECT_LT((state.velocity - difference_quotient(orbit, time)).norm(), 2e-5)
        << letter_of(orbit.satellite.constellation);
    const double clock_moved =
        satellite_state(orbit, time + 50.0).clock - satellite_state(orbit, time + -50.0).clock;
    EXPECT_NEAR(state.clock_drift, clock_moved / 100.0, 1e-16);
  }
}

TEST(BroadcastOrbit, OfTwoMessagesIsTheSame) {
  const GnssTime time = on_24_june(8, 15);
  const SatelliteState earlier = satellite_state(orbit_of<BroadcastOrbit>(kGalileo12At8, kE12, time), time);
  const SatelliteState later = satellite_state(orbit_of<BroadcastOrbit>(kGalileo12At830, kE12, time), time);
  EXPECT_LT((earlier.position - later.position).norm(), 0.5);
  EXPECT_LT((earlier.velocity - later.velocity).norm(), 1e-3);
  EXPECT_LT(std::abs(earlier.clock - later.clock) * kSpeedOfLight, 0.5);
}

TEST(BroadcastOrbit, GeostationaryStandsOverItsLongitude) {
  for (const int minute : {0, 59}) {
    const GnssTime time = on_24_june(8, minute);
    const SatelliteState state = satellite_state(orbit_of<BroadcastOrbit>(kBeidou1, kC01, time), time);
    const Geodetic below = to_geodetic(state.position);
    EXPECT_NEAR(below.longitude_deg, 144.5, 0.5);
    EXPECT_NEAR(below.latitude_deg, 0.0, 2.5);
    EXPECT_NEAR(state.position.norm(), 4.2164e7, 3e4);
    EXPECT_LT(state.velocity.norm(), 150.0);
  }
}

TEST(BroadcastOrbit, ClockHasThePolynomialAndTheRelativisticTerm) {
  BroadcastOrbit orbit = plain_orbit(0.02, 0.9);
  orbit.clock_polynomial = {1e-4, 1e-11, 1e-17};
  const SatelliteState state = satellite_state(orbit, orbit.reference + 1000.0);
  const double by_motion = -2.0 * state.position.dot(state.velocity) / (kSpeedOfLight * kSpeedOfLight);
  EXPECT_GT(std::abs(by_motion), 1e-8);
  EXPECT_NEAR(state.clock, 1e-4 + 1e-8 + 1e-11 + by_motion, 1e-16);
}

TEST(BroadcastOrbit, KnowsBeidousGeostationarySatellites) {
  for (const int number : {1, 5, 59, 60}) EXPECT_TRUE(geostationary({Constellation::kBeidou, number}));
  for (const int number : {6, 30, 58}) EXPECT_FALSE(geostationary({Constellation::kBeidou, number}));
  EXPECT_FALSE(geostationary(kG05));
}

}  // namespace
}  // namespace multipath_localization
