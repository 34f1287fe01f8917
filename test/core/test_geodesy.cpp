#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <limits>
#include <stdexcept>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();
const std::vector<Geodetic> kDatums = {{33.8940, 130.8390, 30.0}, {52.5096, 13.3759, 34.0},
                                       {-33.9, 151.2, 0.0},       {0.0, 0.0, 0.0},
                                       {-54.8, -68.3, 100.0},     {78.2, 15.6, 10.0}};

TEST(LocalFrame, RoundTripReturnsThePoint) {
  for (const Geodetic& datum : kDatums) {
    const LocalFrame frame(datum);
    for (const Eigen::Vector2d& position : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1234.5, -987.6)}) {
      const Geodetic point = frame.to_geodetic(position);
      EXPECT_LT((frame.to_map(point) - position).norm(), 1e-6);
    }
  }
}

TEST(LocalFrame, DatumIsTheOrigin) {
  for (const Geodetic& datum : kDatums) EXPECT_LT(LocalFrame(datum).to_map(datum).norm(), 1e-9);
}

TEST(LocalFrame, DistanceAndAzimuthFromTheDatumAreTheGeodesics) {
  const GeographicLib::Geodesic& wgs84 = GeographicLib::Geodesic::WGS84();
  for (Geodetic datum : kDatums) {
    datum.altitude = 0.0;
    const LocalFrame frame(datum);
    for (double azimuth_deg = -175.0; azimuth_deg < 180.0; azimuth_deg += 25.0) {
      for (const double distance : {1.0, 100.0, 2000.0}) {
        Geodetic point;
        wgs84.Direct(datum.latitude_deg, datum.longitude_deg, azimuth_deg, distance, point.latitude_deg,
                     point.longitude_deg);
        const Eigen::Vector2d position = frame.to_map(point);
        const double azimuth = azimuth_deg * kPi / 180.0;
        const Eigen::Vector2d expected(distance * std::sin(azimuth), distance * std::cos(azimuth));
        EXPECT_LT((position - expected).norm(), 1e-6 * distance);
      }
    }
  }
}

TEST(LocalFrame, UnknownAltitudeCountsAsTheDatums) {
  const LocalFrame frame(kDatums[0]);
  const Geodetic known{33.8951, 130.8402, 30.0};
  const Geodetic unknown{33.8951, 130.8402, kNan};
  EXPECT_EQ(frame.to_map(unknown), frame.to_map(known));
  const LocalFrame flat({33.8940, 130.8390, kNan});
  EXPECT_EQ(flat.datum().altitude, 0.0);
  EXPECT_TRUE(flat.to_map(unknown).allFinite());
}

TEST(LocalFrame, RefusesADatumThatIsNone) {
  for (const Geodetic& datum : {Geodetic{kNan, 0.0, 0.0}, Geodetic{0.0, kNan, 0.0}, Geodetic{90.1, 0.0, 0.0},
                                Geodetic{0.0, 180.1, 0.0}, Geodetic{kInfinity, 0.0, 0.0}}) {
    EXPECT_FALSE(valid(datum));
    EXPECT_THROW(LocalFrame{datum}, std::invalid_argument);
  }
}

/// Steps of equal longitude from 250 m west to 250 m east of the middle have to look equal in the map.
void expect_even_steps(double latitude_deg, double middle_longitude_deg) {
  const LocalFrame frame({latitude_deg, middle_longitude_deg - 1e-4, 0.0});
  const auto at = [&](int i) {
    const double longitude_deg = middle_longitude_deg + 2e-5 * i;
    return frame.to_map({latitude_deg, longitude_deg > 180.0 ? longitude_deg - 360.0 : longitude_deg, 0.0});
  };
  const Eigen::Vector2d step = at(1) - at(0);
  for (int i = -150; i < 150; ++i) EXPECT_LT((at(i + 1) - at(i) - step).norm(), 1e-3) << i;
}

TEST(LocalFrame, HasNoStepAtAnEdgeOfAUtmZone) { expect_even_steps(50.0, 6.0); }

TEST(LocalFrame, HasNoStepAtTheAntimeridian) { expect_even_steps(-17.0, 180.0); }

TEST(Geodetic, IsValidUpToThePolesWithAnyAltitude) {
  EXPECT_TRUE(valid({90.0, 180.0, 0.0}));
  EXPECT_TRUE(valid({-90.0, -180.0, kNan}));
}

}  // namespace
}  // namespace multipath_localization
