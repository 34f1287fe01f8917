#include <gtest/gtest.h>

#include "good_fix.hpp"
#include "ros/inputs/antenna_frames.hpp"
#include "ros/messages/earth_frame.hpp"

namespace multipath_localization {
namespace {

TEST(MapInEarth, TellsTheDatum) {
  for (const Geodetic& datum : {Geodetic{52.5, 13.4, 40.0}, {-33.9, 151.2, -5.0}, {0.0, -179.9, 3000.0}}) {
    const auto back = datum_of(*to_isometry(map_in_earth(LocalFrame(datum))));
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->latitude_deg, datum.latitude_deg, 1e-12);
    EXPECT_NEAR(back->longitude_deg, datum.longitude_deg, 1e-12);
    EXPECT_NEAR(back->altitude, datum.altitude, 1e-8);
  }
}

TEST(MapInEarth, HasUpAwayFromTheCentreAtTheEquator) {
  const geometry_msgs::Transform transform = map_in_earth(LocalFrame(Geodetic{0.0, 0.0, 0.0}));
  EXPECT_NEAR(transform.translation.x, 6378137.0, 1e-6);
  const geometry_msgs::Quaternion& q = transform.rotation;  // east, north, up are y, z, x of the Earth
  EXPECT_NEAR(std::abs(q.w), 0.5, 1e-12);
  EXPECT_NEAR(q.x / q.w, 1.0, 1e-12);
  EXPECT_NEAR(q.y / q.w, 1.0, 1e-12);
  EXPECT_NEAR(q.z / q.w, 1.0, 1e-12);
}

TEST(DatumOf, RefusesOtherAxes) {
  geometry_msgs::Transform transform = map_in_earth(berlin());
  transform.rotation = geometry_msgs::Quaternion();
  transform.rotation.w = 1.0;
  EXPECT_FALSE(datum_of(*to_isometry(transform)));
  transform = map_in_earth(berlin());
  transform.translation.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(to_isometry(transform));
}

}  // namespace
}  // namespace multipath_localization
