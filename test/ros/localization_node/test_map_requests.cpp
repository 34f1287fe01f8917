#include <gtest/gtest.h>

#include <limits>

#include "good_fix.hpp"
#include "ros/localization_node/map_requests.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

SetDatum::Request datum_at(double latitude, double longitude, double altitude) {
  SetDatum::Request request;
  request.geo_pose.position.latitude = latitude;
  request.geo_pose.position.longitude = longitude;
  request.geo_pose.position.altitude = altitude;
  return request;
}

ToLL::Request point_at(double x, double y, double z) {
  ToLL::Request request;
  request.map_point.x = x;
  request.map_point.y = y;
  request.map_point.z = z;
  return request;
}

TEST(MapRequests, MoveTheDatumToWherePlacesAre) {
  Geodetic place;
  EXPECT_EQ(answer(datum_at(52.5, 13.4, 40.0), place), "");
  EXPECT_EQ(place.longitude_deg, 13.4);
  EXPECT_NE(answer(datum_at(91.0, 13.4, 40.0), place), "");
  EXPECT_NE(answer(datum_at(52.5, 13.4, 1e308), place), "");
  SetDatum::Request turned = datum_at(0.0, 0.0, 0.0);
  turned.geo_pose.orientation.z = 0.7;
  EXPECT_NE(answer(turned, place), "");
  EXPECT_EQ(place.altitude, 40.0) << "what is refused changes nothing";
}

TEST(MapRequests, LeadToTheEarthAndBack) {
  ToLL::Response there;
  EXPECT_EQ(answer(point_at(120.0, -40.0, 5.0), &berlin(), there), "");
  FromLL::Request request;
  request.ll_point = there.ll_point;
  FromLL::Response back;
  EXPECT_EQ(answer(request, &berlin(), back), "");
  EXPECT_NEAR(back.map_point.x, 120.0, 1e-6);
  EXPECT_NEAR(back.map_point.y, -40.0, 1e-6);
  EXPECT_NEAR(back.map_point.z, 5.0, 1e-6);
  request.ll_point.altitude = kNan;
  EXPECT_EQ(answer(request, &berlin(), back), "");
  EXPECT_NEAR(back.map_point.z, 0.0, 0.01);
}

TEST(MapRequests, RefuseWhatHasNoAnswer) {
  ToLL::Response place;
  FromLL::Response point;
  EXPECT_NE(answer(point_at(1.0, 2.0, 3.0), nullptr, place), "");
  EXPECT_NE(answer(FromLL::Request(), nullptr, point), "");
  for (const double bad : {kNan, 1.01 * kFurthestPoint, -1e308}) {
    EXPECT_NE(answer(point_at(1.0, 2.0, bad), &berlin(), place), "") << bad;
    EXPECT_NE(answer(point_at(bad, 2.0, 3.0), &berlin(), place), "") << bad;
  }
  FromLL::Request nowhere;
  nowhere.ll_point.latitude = -90.5;
  EXPECT_NE(answer(nowhere, &berlin(), point), "");
}

}  // namespace
}  // namespace multipath_localization
