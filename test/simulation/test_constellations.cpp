#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "multipath_localization/core/angle.hpp"
#include "simulation/constellations.hpp"

namespace multipath_localization {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kSiderealDay = 2.0 * kPi / kEarthRotationRate;

const LocalFrame& map() {
  static const LocalFrame frame({35.0, 139.0, 40.0});
  return frame;
}

std::map<Constellation, int> counted(const std::vector<Satellite>& all) {
  std::map<Constellation, int> counts;
  for (const Satellite& satellite : all) ++counts[satellite.constellation];
  return counts;
}

double elevation(const OrbitState& in_map) { return std::asin(in_map.position.normalized().z()); }

/// How far off in time [s] a satellite is, after `revolution` [s], from where among the stars it was.
double off_after(double revolution, double radius) {
  const CircularOrbit orbit(radius, 1.0, 0.0, 0.0);
  const Eigen::AngleAxisd earth(kEarthRotationRate * revolution, Eigen::Vector3d::UnitZ());
  const double distance = (earth * orbit.at(revolution).position - orbit.at(0.0).position).norm();
  return distance / (2.0 * kPi * radius / revolution);
}

TEST(CircularOrbit, TakesAsLongAsTheSystemsDocumentsSay) {
  EXPECT_LT(off_after(0.5 * kSiderealDay, 26560e3), 10.0);
  EXPECT_LT(off_after(8.0 / 17.0 * kSiderealDay, 25510e3), 20.0);
  EXPECT_LT(off_after(10.0 / 17.0 * kSiderealDay, 29600e3), 20.0);
  EXPECT_LT(off_after(7.0 / 13.0 * kSiderealDay, 27906e3), 20.0);
}

TEST(CircularOrbit, KeepsItsRadiusAndReachesItsInclination) {
  const CircularOrbit orbit(26560e3, 55.0 * kDegree, 0.3, 1.0);
  double highest = 0.0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d position = orbit.at(i * 0.5 * kSiderealDay / 500.0).position;
    EXPECT_NEAR(position.norm(), 26560e3, 1e-3);
    highest = std::max(highest, std::asin(position.z() / position.norm()));
  }
  EXPECT_NEAR(highest, 55.0 * kDegree, 1e-3);
}

TEST(CircularOrbit, NodeAndArgumentSayWhereItStarts) {
  const Eigen::Vector3d at_node = CircularOrbit(2e7, 0.9, 0.4, 0.0).at(0.0).position;
  EXPECT_LT((at_node - 2e7 * Eigen::Vector3d(std::cos(0.4), std::sin(0.4), 0.0)).norm(), 1e-6);
  EXPECT_GT(CircularOrbit(2e7, 0.9, 0.4, 0.0).at(0.0).velocity.z(), 0.0);
  EXPECT_NEAR(CircularOrbit(2e7, 0.9, 0.4, 0.5 * kPi).at(0.0).position.z(), 2e7 * std::sin(0.9), 1e-6);
}

TEST(CircularOrbit, GroundTrackComesBackAfterADayAmongTheStars) {
  const CircularOrbit orbit(26560e3, 55.0 * kDegree, 0.3, 1.0);
  EXPECT_LT((orbit.at(kSiderealDay).position - orbit.at(0.0).position).norm(), 80e3);
  // After one revolution the Earth has turned half way.
  EXPECT_GT((orbit.at(0.5 * kSiderealDay).position - orbit.at(0.0).position).norm(), 20e6);
}

TEST(CircularOrbit, VelocityIsTheDerivativeOfPositionInEcef) {
  const CircularOrbit orbit(25510e3, 64.8 * kDegree, -2.0, 4.0);
  for (const double time : {0.0, 5000.0, -30000.0}) {
    const Eigen::Vector3d moved = orbit.at(time + 0.5).position - orbit.at(time - 0.5).position;
    EXPECT_LT((moved - orbit.at(time).velocity).norm(), 1e-3);
  }
}

TEST(CircularOrbit, FromALaterEpochItGoesOn) {
  const CircularOrbit orbit(27906e3, 55.0 * kDegree, 0.3, 1.0);
  EXPECT_LT((orbit.from(7000.0).at(50.0).position - orbit.at(7050.0).position).norm(), 1e-3);
}

TEST(Satellites, AreThoseOfTheChosenConstellations) {
  const std::map<Constellation, int> all = {{Constellation::kGps, 31},
                                            {Constellation::kGlonass, 24},
                                            {Constellation::kGalileo, 24},
                                            {Constellation::kBeidou, 24}};
  EXPECT_EQ(counted(satellites({}, 1)), all);
  ConstellationParameters parameters;
  parameters.galileo = parameters.beidou = false;
  EXPECT_EQ(satellites(parameters, 1).size(), 55U);
  parameters.gps = false;
  EXPECT_EQ(satellites(parameters, 1).front().constellation, Constellation::kGlonass);
}

TEST(Satellites, StandApartFromEachOther) {
  const std::vector<Satellite> all = satellites({}, 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector3d between = all[i].orbit.at(0.0).position - all[j].orbit.at(0.0).position;
      EXPECT_GT(between.norm(), 300e3) << i << " " << j;
    }
  }
}

TEST(Satellites, EnoughOfEachConstellationAreUpAtAnyTime) {
  for (double time = 0.0; time < 86400.0; time += 1800.0) {
    std::map<Constellation, int> up;
    for (const Satellite& satellite : satellites({}, 1)) {
      const OrbitState state = at_transmission(satellite.orbit, map(), Eigen::Vector3d::Zero(), time);
      if (elevation(state) > 10.0 * kDegree) ++up[satellite.constellation];
    }
    EXPECT_GE(up[Constellation::kGps], 5) << time;
    EXPECT_LE(up[Constellation::kGps], 14) << time;
    for (const auto other : {Constellation::kGlonass, Constellation::kGalileo, Constellation::kBeidou}) {
      EXPECT_GE(up[other], 3) << time;
      EXPECT_LE(up[other], 12) << time;
    }
  }
}

TEST(Satellites, TheSeedChoosesTheTimeWithinTheSpread) {
  ConstellationParameters parameters;
  const auto first = [&](std::uint64_t seed) {
    return satellites(parameters, seed).front().orbit.at(0.0).position;
  };
  EXPECT_EQ(first(1), first(2));
  parameters.epoch_spread = 86400.0;
  EXPECT_GT((first(1) - first(2)).norm(), 1e5);
  EXPECT_EQ(first(1), first(1));
}

/// With the flight time worked out in a frame that does not turn: the satellite stays where it was, the
/// antenna moves on with the Earth.
TEST(AtTransmission, TheSignalHasTravelledAtTheSpeedOfLight) {
  const Eigen::Vector3d antenna(300.0, -200.0, 2.0);
  const Eigen::Vector3d datum = map().satellite_to_ecef(Eigen::Vector3d::Zero());
  const Eigen::Vector3d antenna_in_ecef = datum + map().vector_to_ecef(antenna);
  const double time = 12345.0;
  for (const Satellite& satellite : satellites({}, 1)) {
    const OrbitState state = at_transmission(satellite.orbit, map(), antenna, time);
    const double range = (state.position - antenna).norm();
    const double flight = range / kSpeedOfLight;
    const Eigen::AngleAxisd turn(kEarthRotationRate * flight, Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d way = satellite.orbit.at(time - flight).position - turn * antenna_in_ecef;
    EXPECT_NEAR(way.norm(), range, 0.01);
  }
}

TEST(AtTransmission, ASatelliteOverheadIsOverhead) {
  const LocalFrame equator({0.0, 40.0, 0.0});
  const CircularOrbit orbit(26560e3, 0.0, 40.0 * kDegree, 0.0);
  const OrbitState state = at_transmission(orbit, equator, Eigen::Vector3d::Zero(), 0.0);
  EXPECT_GT(elevation(state), 89.99 * kDegree);
  EXPECT_NEAR(state.position.z(), 26560e3 - 6378137.0, 1.0);
  EXPECT_NEAR(state.velocity.x(), std::sqrt(3.986004418e14 / 26560e3) - kEarthRotationRate * 26560e3, 0.01);
  EXPECT_NEAR(state.velocity.z(), 0.0, 0.1);
}

TEST(AtTransmission, VelocityTellsTheRateOfTheRange) {
  const Eigen::Vector3d antenna(10.0, 20.0, 2.0);
  for (const Satellite& satellite : satellites({}, 1)) {
    const auto range = [&](double time) {
      return (at_transmission(satellite.orbit, map(), antenna, time).position - antenna).norm();
    };
    const OrbitState state = at_transmission(satellite.orbit, map(), antenna, 100.0);
    if (elevation(state) < 0.0) continue;
    const double rate = state.velocity.dot((state.position - antenna).normalized());
    EXPECT_NEAR(rate, range(100.5) - range(99.5), 0.003);
  }
}

}  // namespace
}  // namespace multipath_localization
