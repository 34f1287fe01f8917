#include <gtest/gtest.h>

#include "ros/simulator_node/world_markers.hpp"

namespace multipath_localization {
namespace {

TEST(WorldMarkers, DrawEachZoneAndEachBuildingInTriangles) {
  SimulatorParameters world;
  world.zones.resize(2);  // half-planes x < 0
  world.zones[1].shape = ZoneShape::kPolygon;
  world.zones[1].corners = {5, 5, 9, 5, 9, 9};
  world.buildings.push_back({"house", {0, 0, 4, 0, 4, 3, 0, 3}, 8.0});
  std_msgs::Header header;
  header.frame_id = "map";
  const auto markers = world_markers(world, header).markers;
  ASSERT_EQ(markers.size(), 3U);
  EXPECT_EQ(markers[0].points.size(), 6U);
  for (const auto& point : markers[0].points) EXPECT_LE(point.x, 1e-9);
  EXPECT_EQ(markers[1].points.size(), 3U);
  EXPECT_EQ(markers[2].points.size(), 6U + 4U * 6U);  // roof and four walls
  for (const auto& marker : markers) EXPECT_EQ(marker.header.frame_id, "map");
}

}  // namespace
}  // namespace multipath_localization
