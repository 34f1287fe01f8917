#include "orbits.hpp"
#include "receiver/beidou_message.hpp"

namespace multipath_localization {
namespace {

const SatelliteId kStationary{Constellation::kBeidou, 1}, kSatellite{Constellation::kBeidou, 30};
const GnssTime kSent = on_24_june(8, 46, 30.0);

BroadcastOrbit printed() { return orbit_of<BroadcastOrbit>(kBeidou1, kStationary, on_24_june(8, 0)); }

TEST(BeidouMessage, D2IsWhatRinexPrintsOfIt) {
  BeidouMessage message;
  const auto orbit = put_together(message, kStationary, ubx::beidou_d2(printed(), kSent));
  ASSERT_TRUE(orbit);
  expect_same(*orbit, printed());
}

TEST(BeidouMessage, D1IsWhatRinexPrintsOfIt) {
  BroadcastOrbit expected = printed();
  expected.satellite = kSatellite;
  BeidouMessage message;
  const auto orbit = put_together(message, kSatellite, ubx::beidou_d1(expected, kSent));
  ASSERT_TRUE(orbit);
  expect_same(*orbit, expected);
}

TEST(BeidouMessage, KeepsEveryBitOfEveryField) {
  expect_round_trips<BeidouMessage>(kSatellite,
                                    [](const BroadcastOrbit& orbit) { return ubx::beidou_d1(orbit, kSent); });
  expect_round_trips<BeidouMessage>(kStationary,
                                    [](const BroadcastOrbit& orbit) { return ubx::beidou_d2(orbit, kSent); });
}

TEST(BeidouMessage, PutsNoTwoRoundsTogether) {
  const auto expect_fresh = [](const SatelliteId& satellite, const std::vector<ubx::Words>& old,
                               const std::vector<ubx::Words>& now) {
    for (std::size_t fresh = 0; fresh < now.size(); ++fresh) {
      BeidouMessage message;
      std::size_t whole = 0;
      for (std::size_t i = 0; i < now.size(); ++i) {
        EXPECT_FALSE(message.add(subframe_of(satellite, (i == fresh ? now : old)[i]), reception()));
      }
      for (const ubx::Words& words : now)
        whole += message.add(subframe_of(satellite, words), reception()) ? 1 : 0;
      EXPECT_EQ(whole, 1U);
    }
  };
  expect_fresh(kSatellite, ubx::beidou_d1(printed(), kSent), ubx::beidou_d1(printed(), kSent + 30.0));
  expect_fresh(kStationary, ubx::beidou_d2(printed(), kSent), ubx::beidou_d2(printed(), kSent + 30.0));
}

TEST(BeidouMessage, OfARoundInWhichTheWeekBegins) {
  BroadcastOrbit orbit = printed();
  orbit.satellite = kSatellite;
  BeidouMessage message;
  auto pieces = ubx::beidou_d1(orbit, {2321, 14.0 + 30.0});
  // The first subframe left six seconds before the week.
  const auto last_of_week = ubx::beidou_d1(orbit, {2320, 604794.0 + 14.0});
  ubx::Bits head = ubx::beidou_head(1, 604794);
  pieces[0] = last_of_week[0];
  pieces[0][0] = ubx::padded(head.part(0, 26), 4);
  pieces[0][1] = (pieces[0][1] & 0x3FFFFU) | static_cast<std::uint32_t>(604794 & 0xFFF) << 18;
  for (std::size_t i = 1; i < 3; ++i) {
    const auto second = static_cast<std::int64_t>(6 * (i - 1));
    pieces[i][0] = ubx::padded(ubx::beidou_head(static_cast<int>(i) + 1, second).part(0, 26), 4);
    pieces[i][1] = (pieces[i][1] & 0x3FFFFU) | static_cast<std::uint32_t>(second & 0xFFF) << 18;
  }
  EXPECT_TRUE(put_together(message, kSatellite, pieces));
}

TEST(BeidouMessage, PassesOverWhatIsNoSubframe) {
  BeidouMessage message;
  EXPECT_FALSE(message.add(subframe_of(kSatellite, {}), reception()));
  auto pieces = ubx::beidou_d1(printed(), kSent);
  pieces[1][0] ^= 1U << 25;
  for (const ubx::Words& words : pieces)
    EXPECT_FALSE(message.add(subframe_of(kSatellite, words), reception()));
}

}  // namespace
}  // namespace multipath_localization
