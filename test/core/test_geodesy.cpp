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

TEST(Geodetic, IsValidUpToThePolesAndWithin100KmOfTheEllipsoid) {
  EXPECT_TRUE(valid({-90.0, 180.0, -kHighestAltitude}));
  EXPECT_TRUE(valid({52.5, 13.4, kNan}));
  EXPECT_FALSE(valid({90.1, 0.0, 0.0}));
  EXPECT_FALSE(valid({0.0, -180.1, 0.0}));
  EXPECT_FALSE(valid({kNan, 0.0, 0.0}));
  EXPECT_FALSE(valid({52.5, 13.4, 1.01 * kHighestAltitude}));
  EXPECT_FALSE(valid({52.5, 13.4, -kInfinity}));
}

TEST(LocalFrame, RefusesADatumThatIsNone) {
  EXPECT_THROW(LocalFrame({52.5, 13.4, 1e308}), std::invalid_argument);
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

const std::vector<Eigen::Vector3d> kSatellites = {
    {14567933.9, 2809851.0, 21875628.1}, {14056711.1, 22357508.0, 4819715.6}, {-9.0e6, 1.2e7, 2.1e7}};

TEST(LocalFrame, SatelliteRangesAreThoseWithSagnacsTerm) {
  for (const Geodetic& datum : {kDatums[1], kDatums[0]}) {
    const LocalFrame frame(datum);
    for (const Eigen::Vector3d& satellite : kSatellites) {
      for (const Eigen::Vector3d& receiver_in_map :
           {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(700.0, -700.0, 20.0)}) {
        const Eigen::Vector3d origin = frame.satellite_to_ecef(Eigen::Vector3d::Zero());
        const Eigen::Vector3d receiver = origin + frame.vector_to_ecef(receiver_in_map);
        const double sagnac = kEarthRotationRate / kSpeedOfLight *
                              (satellite.x() * receiver.y() - satellite.y() * receiver.x());
        const double range = (satellite - receiver).norm() + sagnac;
        EXPECT_NEAR((frame.satellite_to_map(satellite) - receiver_in_map).norm(), range, 0.01);
      }
    }
  }
}

TEST(LocalFrame, SatelliteRoundTripReturnsThePosition) {
  for (const Geodetic& datum : kDatums) {
    const LocalFrame frame(datum);
    for (const Eigen::Vector3d& satellite : kSatellites) {
      EXPECT_LT((frame.satellite_to_ecef(frame.satellite_to_map(satellite)) - satellite).norm(), 1e-4);
    }
  }
}

TEST(LocalFrame, SatelliteVelocitiesAreThoseOfTheirRangesWithSagnacsTerm) {
  const LocalFrame frame(kDatums[1]);
  const Eigen::Vector3d receiver = frame.satellite_to_ecef(Eigen::Vector3d::Zero());
  const Eigen::Vector3d velocity(1200.0, -2500.0, 900.0);
  for (const Eigen::Vector3d& satellite : kSatellites) {
    const double sagnac =
        kEarthRotationRate / kSpeedOfLight * (velocity.x() * receiver.y() - velocity.y() * receiver.x());
    const double rate = (satellite - receiver).normalized().dot(velocity) + sagnac;
    const Eigen::Vector3d direction = frame.satellite_to_map(satellite).normalized();
    const Eigen::Vector3d in_map = frame.satellite_velocity_to_map(satellite, velocity);
    EXPECT_NEAR(in_map.dot(direction), rate, 2e-4);
    EXPECT_LT((frame.satellite_velocity_to_ecef(frame.satellite_to_map(satellite), in_map) - velocity).norm(),
              1e-6);
  }
}

TEST(LocalFrame, VectorsPointTheirWay) {
  const LocalFrame frame({0.0, 90.0, 0.0});
  EXPECT_LT((frame.vector_to_map({-1.0, 2.0, 3.0}) - Eigen::Vector3d(1.0, 3.0, 2.0)).norm(), 1e-12);
  EXPECT_LT((frame.vector_to_ecef({1.0, 3.0, 2.0}) - Eigen::Vector3d(-1.0, 2.0, 3.0)).norm(), 1e-12);
}

TEST(Geodetic, OfAPointOnTheEquator) {
  const Geodetic point = to_geodetic(Eigen::Vector3d(0.0, 6378137.0 + 100.0, 0.0));
  EXPECT_NEAR(point.latitude_deg, 0.0, 1e-12);
  EXPECT_NEAR(point.longitude_deg, 90.0, 1e-12);
  EXPECT_NEAR(point.altitude, 100.0, 1e-6);
}

TEST(Geodetic, IsValidUpToThePolesWithAnyAltitude) {
  EXPECT_TRUE(valid({90.0, 180.0, 0.0}));
  EXPECT_TRUE(valid({-90.0, -180.0, kNan}));
}

}  // namespace
}  // namespace multipath_localization
