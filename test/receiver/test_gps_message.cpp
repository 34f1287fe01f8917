#include "orbits.hpp"
#include "receiver/gps_message.hpp"

namespace multipath_localization {
namespace {

const SatelliteId kSatellite{Constellation::kGps, 5};
const GnssTime kSent = on_24_june(8, 46, 30.0);

BroadcastOrbit printed() { return orbit_of<BroadcastOrbit>(kGps5, kSatellite, on_24_june(9, 0)); }

TEST(GpsMessage, IsWhatRinexPrintsOfIt) {
  GpsMessage message;
  const auto orbit = put_together(message, kSatellite, ubx::gps_subframes(printed(), kSent));
  ASSERT_TRUE(orbit);
  expect_same(*orbit, printed());
  EXPECT_EQ(*orbit->sent, reception().gps - orbit->reference);
}

TEST(GpsMessage, KeepsEveryBitOfEveryField) {
  expect_round_trips<GpsMessage>(
      kSatellite, [](const BroadcastOrbit& orbit) { return ubx::gps_subframes(orbit, kSent); });
}

TEST(GpsMessage, PutsNoTwoIssuesOfDataTogether) {
  const auto old = ubx::gps_subframes(printed(), kSent, {76});
  const auto now = ubx::gps_subframes(printed(), kSent, {77});
  const auto add = [](GpsMessage& message, const ubx::Words& words) {
    return message.add(subframe_of(kSatellite, words), reception()).has_value();
  };
  for (std::size_t fresh = 0; fresh < 3; ++fresh) {
    GpsMessage message;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(add(message, (i == fresh ? now : old)[i]));
    EXPECT_FALSE(add(message, now[(fresh + 1) % 3]));
    EXPECT_TRUE(add(message, now[(fresh + 2) % 3])) << "whole as soon as all are of the new one";
  }
}

TEST(GpsMessage, HealthIsOfAllSignalsAndOfQzssOfAllButL1cb) {
  const SatelliteId qzss{Constellation::kQzss, 2};
  for (const auto& [code, gps_healthy, qzss_healthy] :
       {std::tuple{0, true, true}, std::tuple{1, false, true}, std::tuple{32, false, false}}) {
    const auto pieces = ubx::gps_subframes(printed(), kSent, {77, code});
    GpsMessage gps, its;
    EXPECT_EQ(put_together(gps, kSatellite, pieces)->healthy, gps_healthy) << code;
    EXPECT_EQ(put_together(its, qzss, pieces)->healthy, qzss_healthy) << code;
  }
}

TEST(GpsMessage, OfAWeekThatBeginsOrEndsMeanwhile) {
  BroadcastOrbit orbit = printed();
  orbit.toe = 0.0;
  orbit.reference = orbit.clock_reference = {2321, 0.0};
  GpsMessage message;
  const auto before =
      put_together(message, kSatellite, ubx::gps_subframes(orbit, kSent), {{2320, 604000.0}, 18});
  EXPECT_EQ(before->reference.week, 2321);
  const auto after =
      put_together(message, kSatellite, ubx::gps_subframes(orbit, kSent), {{2321, 3000.0}, 18});
  EXPECT_EQ(after->reference.week, 2321);
}

TEST(GpsMessage, PassesOverWhatIsNoSubframe) {
  GpsMessage message;
  auto pieces = ubx::gps_subframes(printed(), kSent);
  EXPECT_FALSE(message.add(subframe_of(kSatellite, {}), reception()));
  pieces[0][0] ^= 1U << 29;
  for (const ubx::Words& words : pieces)
    EXPECT_FALSE(message.add(subframe_of(kSatellite, words), reception()));
}

TEST(GpsIonosphere, IsThatOfPage18) {
  KlobucharCoefficients expected;
  expected.alpha << 25 * std::ldexp(1, -30), -3 * std::ldexp(1, -27), -128 * std::ldexp(1, -24),
      127 * std::ldexp(1, -24);
  expected.beta << 63 * 2048.0, -2 * 16384.0, -128 * 65536.0, 127 * 65536.0;
  const ubx::Words page = ubx::gps_ionosphere_page(expected, kSent);
  const auto ionosphere = gps_ionosphere(subframe_of(kSatellite, page));
  ASSERT_TRUE(ionosphere);
  EXPECT_EQ(ionosphere->alpha, expected.alpha);
  EXPECT_EQ(ionosphere->beta, expected.beta);
  ubx::Words other = page;
  other[2] ^= 1U << 22;
  EXPECT_FALSE(gps_ionosphere(subframe_of(kSatellite, other))) << "another page";
  EXPECT_FALSE(gps_ionosphere(subframe_of(kSatellite, ubx::gps_subframes(printed(), kSent)[0])));
}

}  // namespace
}  // namespace multipath_localization
