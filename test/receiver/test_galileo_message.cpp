#include "orbits.hpp"
#include "receiver/galileo_message.hpp"

namespace multipath_localization {
namespace {

const SatelliteId kSatellite{Constellation::kGalileo, 12};
const GnssTime kSent = on_24_june(8, 46, 30.0);

BroadcastOrbit printed() { return orbit_of<BroadcastOrbit>(kGalileo12At830, kSatellite, on_24_june(8, 30)); }

TEST(GalileoMessage, IsWhatRinexPrintsOfIt) {
  GalileoMessage message;
  const auto orbit = put_together(message, kSatellite, ubx::galileo_words(printed(), kSent));
  ASSERT_TRUE(orbit);
  expect_same(*orbit, printed());
}

TEST(GalileoMessage, KeepsEveryBitOfEveryField) {
  expect_round_trips<GalileoMessage>(
      kSatellite, [](const BroadcastOrbit& orbit) { return ubx::galileo_words(orbit, kSent); });
}

TEST(GalileoMessage, HealthIsThatOfE1bWithAnAccuracyTold) {
  const auto healthy = [](ubx::GalileoCodes codes) {
    GalileoMessage message;
    return put_together(message, kSatellite, ubx::galileo_words(printed(), kSent, codes))->healthy;
  };
  EXPECT_TRUE(healthy({}));
  EXPECT_FALSE(healthy({77, 2, 0, 107})) << "health";
  EXPECT_FALSE(healthy({77, 0, 1, 107})) << "validity of the data";
  EXPECT_FALSE(healthy({77, 0, 0, 255})) << "accuracy";
}

TEST(GalileoMessage, PutsNoTwoIssuesOfDataTogether) {
  const auto old = ubx::galileo_words(printed(), kSent, {76});
  const auto now = ubx::galileo_words(printed(), kSent, {77});
  const auto add = [](GalileoMessage& message, const ubx::Words& words) {
    return message.add(subframe_of(kSatellite, words), reception()).has_value();
  };
  for (std::size_t fresh = 0; fresh < 4; ++fresh) {
    GalileoMessage message;
    for (std::size_t i = 0; i < 5; ++i) EXPECT_FALSE(add(message, (i == fresh ? now : old)[i]));
    std::size_t whole = 0;
    for (std::size_t i = 0; i < 4; ++i) whole += i != fresh && add(message, now[i]) ? 1 : 0;
    EXPECT_EQ(whole, 1U);
  }
}

TEST(GalileoMessage, PassesOverWhatItsCrcRefutes) {
  const auto pieces = ubx::galileo_words(printed(), kSent);
  for (const std::size_t bit : {2U, 30U, 60U, 113U, 130U, 145U, 200U, 209U}) {
    GalileoMessage message;
    auto spoilt = pieces;
    spoilt[2][bit / 32] ^= 1U << (31 - bit % 32);
    for (const ubx::Words& words : spoilt) {
      EXPECT_FALSE(message.add(subframe_of(kSatellite, words), reception())) << bit;
    }
    EXPECT_TRUE(message.add(subframe_of(kSatellite, pieces[2]), reception()));
  }
  GalileoMessage message;
  EXPECT_FALSE(message.add(subframe_of(kSatellite, {}), reception()));
}

}  // namespace
}  // namespace multipath_localization
