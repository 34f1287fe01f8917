#include <gtest/gtest.h>

#include "broadcast.hpp"
#include "rinex/navigation_writer.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const std::string kMessages = std::string(kGps5) + kGalileo12At8 + kGalileo12At830 + kBeidou1 +
                              kGlonass1At815 + kGlonass1At845 +
                              replaced(replaced(kGps5, "G05", "J02"), "0.000000000000E+00-1.071020960808E-08",
                                       "2.000000000000E+00-1.071020960808E-08");

Navigation read_again(const Navigation& navigation) { return navigation_of(navigation_text(navigation)); }

TEST(NavigationText, IsReadAgainAsItWas) {
  const Navigation navigation = navigation_of(navigation_header() + kMessages);
  const Navigation again = read_again(navigation);
  EXPECT_TRUE(again.left_out.empty());
  EXPECT_FALSE(again.ionosphere);
  EXPECT_EQ(navigation_text(again), navigation_text(navigation));
  const auto before = navigation.ephemerides.all(), after = again.ephemerides.all();
  ASSERT_EQ(before.size(), 7U);
  ASSERT_EQ(after.size(), before.size());
  const GnssTime time = on_24_june(8, 40);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const SatelliteState was = satellite_state(before[i], time), is = satellite_state(after[i], time);
    EXPECT_LT((is.position - was.position).norm(), 1e-4) << i;
    EXPECT_NEAR(is.clock, was.clock, 1e-15) << i;
    EXPECT_NEAR(group_delay(after[i]), group_delay(before[i]), 1e-20) << i;
    EXPECT_EQ(carrier_frequency(after[i]), carrier_frequency(before[i])) << i;
  }
}

TEST(NavigationText, KeepsHealthAndTheIonosphere) {
  Navigation navigation;
  BroadcastOrbit orbit = circling_satellites(Constellation::kGps, 1, 1).front();
  navigation.ionosphere = summer_ionosphere();
  for (int i = 0; i < kConstellations; ++i) {
    orbit.satellite = {static_cast<Constellation>(i), 20};
    orbit.healthy = false;
    if (orbit.satellite.constellation != Constellation::kGlonass) navigation.ephemerides.add(orbit);
  }
  const Navigation again = read_again(navigation);
  EXPECT_EQ(again.ephemerides.all().size(), 4U);
  EXPECT_TRUE(again.ephemerides.usable(orbit.reference).empty());
  ASSERT_TRUE(again.ionosphere);
  EXPECT_TRUE(again.ionosphere->alpha.isApprox(navigation.ionosphere->alpha, 1e-4));
  EXPECT_TRUE(again.ionosphere->beta.isApprox(navigation.ionosphere->beta, 1e-4));
}

}  // namespace
}  // namespace multipath_localization
