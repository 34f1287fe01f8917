#include <gtest/gtest.h>

#include "rinex/satellite_id.hpp"

namespace multipath_localization {
namespace {

TEST(SatelliteId, LettersAreThoseOfRinex) {
  EXPECT_EQ(constellation_of_letter('G'), Constellation::kGps);
  EXPECT_EQ(constellation_of_letter('R'), Constellation::kGlonass);
  EXPECT_EQ(constellation_of_letter('E'), Constellation::kGalileo);
  EXPECT_EQ(constellation_of_letter('C'), Constellation::kBeidou);
  EXPECT_EQ(constellation_of_letter('J'), Constellation::kQzss);
  for (const char other : {'S', 'I', ' ', 'g', '\0'}) EXPECT_FALSE(constellation_of_letter(other));
  for (int i = 0; i < kConstellations; ++i) {
    EXPECT_EQ(constellation_of_letter(letter_of(static_cast<Constellation>(i))),
              static_cast<Constellation>(i));
  }
}

TEST(SatelliteId, OrdersBySystemThenNumber) {
  const SatelliteId gps5{Constellation::kGps, 5};
  EXPECT_LT(gps5, (SatelliteId{Constellation::kGps, 6}));
  EXPECT_LT(gps5, (SatelliteId{Constellation::kGlonass, 1}));
  EXPECT_FALSE(gps5 < gps5);
  EXPECT_EQ(gps5, (SatelliteId{Constellation::kGps, 5}));
}

}  // namespace
}  // namespace multipath_localization
