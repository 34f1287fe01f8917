#include "../rinex/sky.hpp"
#include "orbits.hpp"
#include "receiver/broadcast_decoder.hpp"

namespace multipath_localization {
namespace {

const std::string kAll = std::string(kGps5) + kGalileo12At830 + kBeidou1 + kGlonass1At845;

/// Hands over what the satellite sends of it, all but the first `missing` pieces.
void send(const Ephemeris& ephemeris, BroadcastDecoder& decoder, Navigation& navigation,
          std::size_t missing = 0) {
  const auto* glonass = std::get_if<GlonassOrbit>(&ephemeris);
  const auto pieces = ubx::broadcast(ephemeris, reception().gps);
  for (std::size_t i = missing; i < pieces.size(); ++i) {
    decoder.add(
        subframe_of(ubx::satellite_of(ephemeris), pieces[i], glonass == nullptr ? 0 : glonass->channel),
        reception(), navigation);
  }
}

TEST(BroadcastDecoder, PutsTogetherWhatEachSystemSends) {
  const Navigation printed = navigation_of(navigation_header() + kAll);
  BroadcastDecoder decoder;
  Navigation navigation;
  for (const Ephemeris& ephemeris : printed.ephemerides.all()) send(ephemeris, decoder, navigation);
  EXPECT_EQ(decoder.ephemerides(), 4U);
  EXPECT_EQ(decoder.impossible(), 0U);
  const auto all = navigation.ephemerides.all(), expected = printed.ephemerides.all();
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(ubx::satellite_of(all[i]) == ubx::satellite_of(expected[i]));
    const auto state = satellite_state(all[i], reception().gps),
               printed_state = satellite_state(expected[i], reception().gps);
    EXPECT_LT((state.position - printed_state.position).norm(), 1e-3);
    EXPECT_NEAR(state.clock, printed_state.clock, 1e-14);
  }
}

TEST(BroadcastDecoder, KeepsThePiecesOfSatellitesApart) {
  BroadcastDecoder decoder;
  Navigation navigation;
  auto orbit = any_orbit({Constellation::kGps, 1}, 1);
  send(orbit, decoder, navigation, 1);
  orbit.satellite.number = 2;
  send(orbit, decoder, navigation);
  EXPECT_EQ(navigation.ephemerides.all().size(), 1U);
}

TEST(BroadcastDecoder, LeavesOutImpossibleOrbits) {
  BroadcastDecoder decoder;
  Navigation navigation;
  auto orbit = any_orbit({Constellation::kGps, 1}, 1);
  orbit.eccentricity = 0.0;
  orbit.root_axis = 10.0;
  send(orbit, decoder, navigation);
  EXPECT_EQ(decoder.impossible(), 1U);
  EXPECT_TRUE(navigation.ephemerides.all().empty());
}

TEST(BroadcastDecoder, TakesTheIonosphereOfGpsBeforeThatOfQzss) {
  BroadcastDecoder decoder;
  Navigation navigation;
  const auto hear = [&](Constellation constellation, double factor) {
    KlobucharCoefficients told;
    told.alpha << factor * std::ldexp(1.0, -30), 0.0, 0.0, 0.0;
    told.beta << factor * 2048.0, 0.0, 0.0, 0.0;
    decoder.add(subframe_of({constellation, 3}, ubx::gps_ionosphere_page(told, reception().gps)), reception(),
                navigation);
    return navigation.ionosphere ? navigation.ionosphere->beta(0) / 2048.0 : -1.0;
  };
  EXPECT_EQ(hear(Constellation::kGps, 0.0), -1.0) << "nothing but zeros";
  EXPECT_EQ(hear(Constellation::kQzss, 5.0), 5.0);
  EXPECT_EQ(hear(Constellation::kGps, 7.0), 7.0);
  EXPECT_EQ(hear(Constellation::kQzss, 9.0), 7.0);
  EXPECT_EQ(hear(Constellation::kGps, 8.0), 8.0);
}

}  // namespace
}  // namespace multipath_localization
