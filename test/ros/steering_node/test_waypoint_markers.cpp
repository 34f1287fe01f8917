#include <gtest/gtest.h>

#include <algorithm>

#include "ros/steering_node/waypoint_markers.hpp"

namespace multipath_localization {
namespace {

TEST(WaypointMarkers, ShowTheTarget) {
  WaypointFollower follower(WaypointFollowerParameters{}, {{0.0, 0.0}, {10.0, 5.0}});
  follower.command({}, 0.0, Trust::kGood);  // passes the first
  const auto markers = waypoint_markers(follower, "map").markers;
  const auto target =
      std::find_if(markers.begin(), markers.end(), [](const auto& marker) { return marker.ns == "target"; });
  ASSERT_NE(target, markers.end());
  EXPECT_EQ(target->pose.position.x, 10.0);
  EXPECT_EQ(target->pose.position.y, 5.0);
}

TEST(WaypointMarkers, OfNoWaypointsOnlyClear) {
  const WaypointFollower follower(WaypointFollowerParameters{}, {});
  EXPECT_EQ(waypoint_markers(follower, "map").markers.size(), 1U);
}

}  // namespace
}  // namespace multipath_localization
