#include "orbits.hpp"
#include "receiver/glonass_message.hpp"

namespace multipath_localization {
namespace {

const SatelliteId kSatellite{Constellation::kGlonass, 1};

GlonassOrbit printed() { return orbit_of<GlonassOrbit>(kGlonass1At845, kSatellite, on_24_june(8, 45)); }

GlonassOrbit any_glonass_orbit(unsigned seed) {
  std::mt19937 random(seed);
  const auto within = [&](double bound) {
    return std::uniform_real_distribution<double>(-bound, bound)(random);
  };
  const auto vector = [&](double bound) {
    return Eigen::Vector3d(within(bound), within(bound), within(bound));
  };
  GlonassOrbit orbit;
  orbit.satellite = kSatellite;
  orbit.healthy = seed % 3 != 0;
  orbit.channel = static_cast<int>(seed % 14) - 7;
  orbit.reference = GnssTime{2320, 86400.0 + 900.0 * (30 + seed % 8) + 18.0};
  orbit.position = vector(3.2e7);
  orbit.velocity = vector(7.9e3);
  orbit.acceleration = vector(1.3e-5);
  orbit.clock = within(1.9e-3);
  orbit.clock_drift = within(9e-10);
  return orbit;
}

TEST(GlonassMessage, IsWhatRinexPrintsOfIt) {
  GlonassMessage message;
  const auto orbit =
      put_together(message, kSatellite, ubx::glonass_strings(printed(), 18), reception(), printed().channel);
  ASSERT_TRUE(orbit);
  expect_same(*orbit, printed());
}

TEST(GlonassMessage, KeepsEveryBitOfEveryField) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const GlonassOrbit any = any_glonass_orbit(seed);
    const auto pieces = ubx::glonass_strings(any, 18);
    GlonassMessage message;
    const auto orbit = put_together(message, kSatellite, pieces, reception(), any.channel);
    ASSERT_TRUE(orbit);
    EXPECT_EQ(ubx::glonass_strings(*orbit, 18), pieces) << seed;
    EXPECT_EQ(orbit->reference - any.reference, 0.0);
    EXPECT_EQ(orbit->healthy, any.healthy);
    EXPECT_EQ(orbit->channel, any.channel);
  }
}

TEST(GlonassMessage, PutsNoTwoFramesTogether) {
  const auto pieces = ubx::glonass_strings(printed(), 18);
  GlonassMessage message;
  const auto add = [&](std::size_t i, double later) {
    return message.add(subframe_of(kSatellite, pieces[i]), {reception().gps + later, 18}).has_value();
  };
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(add(i, 2.0 * static_cast<double>(i)));
  EXPECT_FALSE(add(3, 36.0)) << "the fourth string was that of the next frame";
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(add(i, 60.0 + 2.0 * static_cast<double>(i)));
  EXPECT_TRUE(add(3, 66.0));
}

TEST(GlonassMessage, TheFlagOfTheThirdStringIsOfHealthToo) {
  auto pieces = ubx::glonass_strings(printed(), 18);
  const auto flip = [&](int bit) {
    pieces[2][static_cast<std::size_t>(85 - bit) / 32] ^= 1U << (31 - (85 - bit) % 32);
  };
  flip(65);
  GlonassMessage spoilt;
  for (const ubx::Words& words : pieces)
    EXPECT_FALSE(spoilt.add(subframe_of(kSatellite, words), reception()));
  // Bit 65 is of the checks 1, 2, 3, 4, 5 and 6, an even number: with the bit itself the sum becomes odd.
  for (const int bit : {1, 2, 3, 4, 5, 6, 8}) flip(bit);
  GlonassMessage message;
  const auto orbit = put_together(message, kSatellite, pieces);
  ASSERT_TRUE(orbit);
  EXPECT_FALSE(orbit->healthy);
}

TEST(GlonassString, HoldsUntilOneOrTwoBitsAreWrong) {
  BitString good;
  const auto strings = ubx::glonass_strings(printed(), 18);
  for (const std::uint32_t word : strings[1]) good.append(word, 32);
  EXPECT_TRUE(glonass_string_holds(good));
  const auto flipped = [](const BitString& bits, std::size_t place) {
    BitString other;
    for (std::size_t i = 0; i < bits.size(); ++i) other.append(bits.at(i) != (i == place) ? 1 : 0, 1);
    return other;
  };
  for (std::size_t i = 0; i < 85; ++i) {
    const BitString once = flipped(good, i);
    EXPECT_FALSE(glonass_string_holds(once)) << i;
    EXPECT_FALSE(glonass_string_holds(flipped(once, (i + 37) % 85))) << i;
  }
}

}  // namespace
}  // namespace multipath_localization
