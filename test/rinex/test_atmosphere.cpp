#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "rinex/atmosphere.hpp"

namespace multipath_localization {
namespace {

constexpr double kDegree = kPi / 180.0;

KlobucharCoefficients coefficients() {
  KlobucharCoefficients all;
  all.alpha << 3.82e-8, 1.49e-8, -1.79e-7, 0.0;
  all.beta << 1.43e5, 0.0, -3.28e5, 1.13e5;
  return all;
}

TEST(Direction, IsByTheCompass) {
  const Direction east = direction_of({1.0, 0.0, std::sqrt(3.0)});
  EXPECT_NEAR(east.azimuth, kPi / 2.0, 1e-12);
  EXPECT_NEAR(east.elevation, kPi / 3.0, 1e-12);
  EXPECT_NEAR(direction_of({0.0, 1.0, 0.0}).azimuth, 0.0, 1e-12);
}

TEST(Klobuchar, IsThatOfThePublishedExample) {
  // The worked example of M. Mahooti's published implementation: 40 N, 100 W, azimuth 210, elevation 20.
  const double delay =
      klobuchar_delay(coefficients(), {40.0, -100.0, 0.0}, {210.0 * kDegree, 20.0 * kDegree}, {0, 593100.0});
  EXPECT_NEAR(delay, 23.784, 1e-3);
}

TEST(Klobuchar, IsFiveNanosecondsAtNightAndSlanted) {
  const GnssTime night{0, 86400.0 * 3.0 + 3600.0 * 2.0};
  const Geodetic greenwich{50.0, 0.0, 0.0};
  const double above = klobuchar_delay(coefficients(), greenwich, {0.0, 90.0 * kDegree}, night);
  EXPECT_NEAR(above, 5e-9 * kSpeedOfLight, 1e-3);
  const double low = klobuchar_delay(coefficients(), greenwich, {0.0, 5.0 * kDegree}, night);
  const auto slant = [](double elevation_deg) {
    return 1.0 + 16.0 * std::pow(0.53 - elevation_deg / 180.0, 3);
  };
  EXPECT_NEAR(low / above, slant(5.0) / slant(90.0), 1e-9);
  EXPECT_GT(klobuchar_delay(coefficients(), greenwich, {0.0, 90.0 * kDegree}, night + 12.0 * 3600.0),
            3.0 * above);
}

TEST(Saastamoinen, IsTwoMetresFortyAtTheZenithAndGrowsToTheHorizon) {
  const Geodetic sea{45.0, 10.0, 0.0};
  const double zenith = saastamoinen_delay(sea, 90.0 * kDegree);
  EXPECT_NEAR(zenith, 2.307 + 0.12, 0.01);  // 0.0022768 * 1013.25 dry, some 12 hPa of vapour
  EXPECT_NEAR(saastamoinen_delay(sea, 30.0 * kDegree), 2.0 * zenith, 1e-9);
  EXPECT_DOUBLE_EQ(saastamoinen_delay(sea, -10.0 * kDegree), saastamoinen_delay(sea, 3.0 * kDegree));
}

TEST(Saastamoinen, ThinsOutWithHeightAndStaysFinite) {
  const double zenith = 90.0 * kDegree;
  EXPECT_NEAR(
      saastamoinen_delay({45.0, 10.0, 2000.0}, zenith) / saastamoinen_delay({45.0, 10.0, 0.0}, zenith), 0.78,
      0.02);
  EXPECT_EQ(saastamoinen_delay({45.0, 10.0, 1e7}, zenith), 0.0);
  EXPECT_LT(saastamoinen_delay({45.0, 10.0, -1e7}, zenith), 3.0);
}

}  // namespace
}  // namespace multipath_localization
