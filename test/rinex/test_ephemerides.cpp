#include <gtest/gtest.h>

#include "broadcast.hpp"
#include "rinex/ephemerides.hpp"

namespace multipath_localization {
namespace {

BroadcastOrbit orbit_at(Constellation constellation, double second, bool healthy = true) {
  BroadcastOrbit orbit;
  orbit.satellite = {constellation, 7};
  orbit.reference = {2320, second};
  orbit.healthy = healthy;
  return orbit;
}

double reference_of(const Ephemeris* ephemeris) {
  if (ephemeris == nullptr) return -1.0;
  return std::visit([](const auto& e) { return e.reference.second; }, *ephemeris);
}

TEST(Ephemerides, FindsTheNearestOfTheSatellite) {
  Ephemerides all;
  for (const double second : {1000.0, 8200.0, 15400.0}) all.add(orbit_at(Constellation::kGps, second));
  const SatelliteId satellite{Constellation::kGps, 7};
  EXPECT_EQ(reference_of(all.find(satellite, {2320, 4500.0})), 1000.0);
  EXPECT_EQ(reference_of(all.find(satellite, {2320, 4700.0})), 8200.0);
  EXPECT_EQ(all.find({Constellation::kGps, 8}, {2320, 4500.0}), nullptr);
  EXPECT_EQ(all.find({Constellation::kGalileo, 7}, {2320, 4500.0}), nullptr);
}

TEST(Ephemerides, OfTwoMessagesOfOneReferenceTheOneSentLaterSpeaks) {
  const SatelliteId satellite{Constellation::kGps, 7};
  BroadcastOrbit first = orbit_at(Constellation::kGps, 8200.0);
  first.sent = -7000.0;
  BroadcastOrbit warning = orbit_at(Constellation::kGps, 8200.0, false);
  warning.sent = -600.0;
  for (const bool in_order : {true, false}) {
    Ephemerides all;
    all.add(in_order ? first : warning);
    all.add(in_order ? warning : first);
    EXPECT_EQ(all.find(satellite, {2320, 8000.0}), nullptr);
  }
}

TEST(Ephemerides, OfTwoMessagesSentWhoKnowsWhenTheOneAddedLaterSpeaks) {
  const SatelliteId satellite{Constellation::kGps, 7};
  for (const bool healthy_last : {true, false}) {
    Ephemerides all;
    all.add(orbit_at(Constellation::kGps, 8200.0, !healthy_last));
    all.add(orbit_at(Constellation::kGps, 8200.0, healthy_last));
    EXPECT_EQ(all.find(satellite, {2320, 8000.0}) != nullptr, healthy_last);
  }
}

TEST(Ephemerides, NoneIsUsedBeyondItsWindow) {
  const std::vector<std::pair<Constellation, double>> windows = {{Constellation::kGps, 7200.0},
                                                                 {Constellation::kGalileo, 14400.0},
                                                                 {Constellation::kBeidou, 21600.0},
                                                                 {Constellation::kQzss, 7200.0}};
  for (const auto& [constellation, window] : windows) {
    Ephemerides all;
    all.add(orbit_at(constellation, 50000.0));
    EXPECT_NE(all.find({constellation, 7}, {2320, 50000.0 + window}), nullptr);
    EXPECT_EQ(all.find({constellation, 7}, {2320, 50001.0 + window}), nullptr);
    EXPECT_EQ(all.find({constellation, 7}, {2320, 49999.0 - window}), nullptr);
    EXPECT_EQ(all.find({constellation, 7}, {2321, 50000.0}), nullptr);
  }
  Ephemerides glonass;
  GlonassOrbit orbit;
  orbit.satellite = {Constellation::kGlonass, 7};
  orbit.reference = {2320, 50000.0};
  glonass.add(orbit);
  EXPECT_NE(glonass.find({Constellation::kGlonass, 7}, {2320, 51800.0}), nullptr);
  EXPECT_EQ(glonass.find({Constellation::kGlonass, 7}, {2320, 51801.0}), nullptr);
}

TEST(Ephemerides, AnUnhealthySatelliteIsNotFound) {
  Ephemerides all;
  all.add(orbit_at(Constellation::kGps, 1000.0));
  all.add(orbit_at(Constellation::kGps, 8200.0, false));
  EXPECT_EQ(reference_of(all.find({Constellation::kGps, 7}, {2320, 2000.0})), 1000.0);
  EXPECT_EQ(all.find({Constellation::kGps, 7}, {2320, 8000.0}), nullptr);
}

TEST(Ephemerides, TellTheirSpan) {
  Ephemerides all;
  EXPECT_FALSE(all.span());
  all.add(orbit_at(Constellation::kGps, 8200.0, false));
  all.add(orbit_at(Constellation::kGalileo, 1000.0));
  EXPECT_EQ(all.span()->first.second, 1000.0);
  EXPECT_EQ(all.span()->second.second, 8200.0);
}

TEST(Ephemerides, CarriersAreL1E1B1IAndGlonasssChannel) {
  EXPECT_DOUBLE_EQ(carrier_frequency(orbit_at(Constellation::kGps, 0.0)), 1575.42e6);
  EXPECT_DOUBLE_EQ(carrier_frequency(orbit_at(Constellation::kGalileo, 0.0)), 1575.42e6);
  EXPECT_DOUBLE_EQ(carrier_frequency(orbit_at(Constellation::kQzss, 0.0)), 1575.42e6);
  EXPECT_DOUBLE_EQ(carrier_frequency(orbit_at(Constellation::kBeidou, 0.0)), 1561.098e6);
  EXPECT_DOUBLE_EQ(carrier_frequency(orbit_at(Constellation::kBeidou, 0.0), true), 1575.42e6) << "B1C";
  GlonassOrbit glonass;
  glonass.channel = -7;
  EXPECT_DOUBLE_EQ(carrier_frequency(glonass), 1598.0625e6);
}

TEST(TransmissionTime, LeavesReceiverClockOutAndTakesSatelliteClockIn) {
  const GnssTime sent = on_24_june(8, 20);
  const SatelliteId satellite{Constellation::kGps, 5};
  const Ephemeris ephemeris = orbit_of<BroadcastOrbit>(kGps5, satellite, sent);
  const double clock = satellite_state(ephemeris, sent).clock;
  ASSERT_GT(std::abs(clock), 1e-4);
  for (const double receiver_clock : {0.0, 0.7e-3, -0.2}) {
    const GnssTime heard_at = sent + 0.0712 + receiver_clock;
    const double pseudorange = kSpeedOfLight * (0.0712 + receiver_clock - clock);
    EXPECT_NEAR(transmission_time(ephemeris, heard_at, pseudorange) - sent, 0.0, 1e-10);
  }
}

TEST(Ephemerides, OfAStreamTheLatestOfAReferenceAndTheLastFortyAreKept) {
  Ephemerides ephemerides;
  BroadcastOrbit orbit = orbit_of<BroadcastOrbit>(kGps5, {Constellation::kGps, 5}, on_24_june(9, 0));
  const GnssTime first = orbit.reference;
  for (int i = 0; i < 100; ++i) {
    orbit.reference = first + 16.0 * i;
    ephemerides.update(orbit);
    ephemerides.update(orbit);
  }
  EXPECT_EQ(ephemerides.all().size(), 40U);
  EXPECT_EQ(ephemerides.usable(first).size(), 1U);
  orbit.healthy = false;
  ephemerides.update(orbit);
  EXPECT_EQ(ephemerides.all().size(), 40U);
  EXPECT_EQ(ephemerides.find(orbit.satellite, orbit.reference), nullptr);
  EXPECT_TRUE(ephemerides.usable(orbit.reference).empty());
}

}  // namespace
}  // namespace multipath_localization
