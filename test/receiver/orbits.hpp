#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "../rinex/broadcast.hpp"
#include "receiver/subframe.hpp"
#include "ubx_encoder.hpp"

namespace multipath_localization {

/// When what broadcast.hpp holds was received.
inline ReceptionTime reception() { return {on_24_june(8, 47, 3.25), 18}; }

inline Subframe subframe_of(const SatelliteId& satellite, const ubx::Words& words, int channel = 0) {
  return {satellite, channel, words};
}

/// What the last of the pieces makes whole.
template <class Message>
auto put_together(Message& message, const SatelliteId& satellite, const std::vector<ubx::Words>& pieces,
                  const ReceptionTime& now = reception(), int channel = 0) {
  auto orbit = message.add(subframe_of(satellite, pieces.front(), channel), now);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    EXPECT_FALSE(orbit) << "whole before its last piece";
    orbit = message.add(subframe_of(satellite, pieces[i], channel), now);
  }
  return orbit;
}

inline void expect_near(double value, double expected, const char* what) {
  EXPECT_NEAR(value, expected, 2e-12 * std::abs(expected)) << what;
}

template <class Vector>
void expect_near_each(const Vector& value, const Vector& expected, const char* what) {
  for (Eigen::Index i = 0; i < value.size(); ++i) expect_near(value(i), expected(i), what);
}

/// The same to the digits that RINEX prints.
inline void expect_same(const BroadcastOrbit& orbit, const BroadcastOrbit& expected) {
  EXPECT_TRUE(orbit.satellite == expected.satellite);
  EXPECT_EQ(orbit.healthy, expected.healthy);
  EXPECT_EQ(orbit.reference - expected.reference, 0.0);
  EXPECT_EQ(orbit.clock_reference - expected.clock_reference, 0.0);
  expect_near(orbit.toe, expected.toe, "toe");
  expect_near(orbit.root_axis, expected.root_axis, "root_axis");
  expect_near(orbit.eccentricity, expected.eccentricity, "eccentricity");
  expect_near(orbit.inclination, expected.inclination, "inclination");
  expect_near(orbit.node, expected.node, "node");
  expect_near(orbit.perigee, expected.perigee, "perigee");
  expect_near(orbit.mean_anomaly, expected.mean_anomaly, "mean_anomaly");
  expect_near(orbit.mean_motion_difference, expected.mean_motion_difference, "mean_motion_difference");
  expect_near(orbit.node_rate, expected.node_rate, "node_rate");
  expect_near(orbit.inclination_rate, expected.inclination_rate, "inclination_rate");
  expect_near_each(orbit.latitude_correction, expected.latitude_correction, "latitude_correction");
  expect_near_each(orbit.radius_correction, expected.radius_correction, "radius_correction");
  expect_near_each(orbit.inclination_correction, expected.inclination_correction, "inclination_correction");
  expect_near_each(orbit.clock_polynomial, expected.clock_polynomial, "clock_polynomial");
  expect_near(orbit.group_delay, expected.group_delay, "group_delay");
}

inline void expect_same(const GlonassOrbit& orbit, const GlonassOrbit& expected) {
  EXPECT_TRUE(orbit.satellite == expected.satellite);
  EXPECT_EQ(orbit.healthy, expected.healthy);
  EXPECT_EQ(orbit.channel, expected.channel);
  EXPECT_EQ(orbit.reference - expected.reference, 0.0);
  expect_near_each(orbit.position, expected.position, "position");
  expect_near_each(orbit.velocity, expected.velocity, "velocity");
  expect_near_each(orbit.acceleration, expected.acceleration, "acceleration");
  expect_near(orbit.clock, expected.clock, "clock");
  expect_near(orbit.clock_drift, expected.clock_drift, "clock_drift");
}

/// Any orbit whose fields fit into GPS's, Galileo's and BeiDou's messages, of both signs each.
inline BroadcastOrbit any_orbit(const SatelliteId& satellite, unsigned seed) {
  std::mt19937 random(seed);
  const auto within = [&](double bound) {
    return std::uniform_real_distribution<double>(-bound, bound)(random);
  };
  const auto pair = [&](double bound) { return Eigen::Vector2d(within(bound), within(bound)); };
  BroadcastOrbit orbit;
  orbit.satellite = satellite;
  orbit.healthy = seed % 3 != 0;
  const double ahead = satellite.constellation == Constellation::kBeidou ? 14.0 : 0.0;
  orbit.toe = 115200.0 + 3600.0 * (seed % 4);
  orbit.reference = GnssTime{2320, orbit.toe + ahead};
  orbit.clock_reference = orbit.reference + -3600.0 * (seed % 2);
  orbit.root_axis = 5600.0 + within(1000.0);
  orbit.eccentricity = 0.015 + within(0.015);
  for (double* angle : {&orbit.inclination, &orbit.node, &orbit.perigee, &orbit.mean_anomaly})
    *angle = within(kPi);
  orbit.mean_motion_difference = within(1.1e-8);
  orbit.node_rate = within(2.9e-6);
  orbit.inclination_rate = within(2.9e-9);
  orbit.latitude_correction = pair(6e-5);
  orbit.radius_correction = pair(1000.0);
  orbit.inclination_correction = pair(6e-5);
  orbit.clock_polynomial = {within(9e-4), within(3.6e-9), within(4e-17)};
  orbit.group_delay = within(5e-8);
  return orbit;
}

/// That decoding and encoding again gives the same bits, whatever the fields are.
template <class Message, class Encode>
void expect_round_trips(const SatelliteId& satellite, const Encode& encode) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const std::vector<ubx::Words> pieces = encode(any_orbit(satellite, seed));
    Message message;
    const auto orbit = put_together(message, satellite, pieces);
    ASSERT_TRUE(orbit) << seed;
    ASSERT_EQ(encode(*orbit), pieces) << seed;
  }
}

}  // namespace multipath_localization
