#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ros/steering_node/waypoint_markers.hpp"

namespace multipath_localization {
namespace {

TEST(WaypointMarkers, ShowTheTarget) {
  WaypointFollower follower(WaypointFollowerParameters{}, {{0.0, 0.0}, {10.0, 5.0}});
  follower.command({}, 0.0, Trust::kGood);  // passes the first
  const auto markers = waypoint_markers(follower, "map", 1.5).markers;
  const auto target =
      std::find_if(markers.begin(), markers.end(), [](const auto& marker) { return marker.ns == "target"; });
  ASSERT_NE(target, markers.end());
  EXPECT_EQ(target->pose.position.x, 10.0);
  EXPECT_EQ(target->pose.position.y, 5.0);
}

TEST(WaypointMarkers, ShowThePathByThePlannedSpeed) {
  WaypointFollowerParameters parameters;
  parameters.loop = false;
  WaypointFollower follower(parameters, {{10.0, 0.0}, {10.0, 10.0}});
  const auto way = [&] {
    const auto markers = waypoint_markers(follower, "map", parameters.cruise_speed).markers;
    return *std::find_if(markers.begin(), markers.end(), [](const auto& m) { return m.ns == "way"; });
  };
  EXPECT_EQ(way().points.size(), 3U);  // lines, there and back
  follower.command({}, 0.0, Trust::kGood);
  const auto path = way();
  ASSERT_EQ(path.points.size(), path.colors.size());
  for (const auto& place : path.points) EXPECT_GT(std::hypot(place.x - 10.0, place.y), 0.99);
  EXPECT_NEAR(path.points.back().y, 10.0, 1e-9);
  EXPECT_EQ(path.colors.front().g, 1.0F);
  EXPECT_EQ(path.colors.front().r, 0.0F);
  EXPECT_EQ(path.colors.back().g, 0.0F);
  EXPECT_EQ(path.colors.back().r, 1.0F);
}

TEST(WaypointMarkers, OfNoWaypointsOnlyClear) {
  const WaypointFollower follower(WaypointFollowerParameters{}, {});
  EXPECT_EQ(waypoint_markers(follower, "map", 1.5).markers.size(), 1U);
}

}  // namespace
}  // namespace multipath_localization
