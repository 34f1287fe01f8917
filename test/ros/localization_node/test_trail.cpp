#include <gtest/gtest.h>

#include "ros/localization_node/trail.hpp"

namespace multipath_localization {
namespace {

void drive(Trail& trail, double from, double to, double step) {
  for (double x = from; x <= to; x += step) {
    std_msgs::Header header;
    header.frame_id = "map";
    header.stamp.fromSec(100.0 + x);
    geometry_msgs::Pose pose;
    pose.position.x = x;
    trail.add(header, pose);
  }
}

TEST(Trail, KeepsTheLastPosesSomeWayApart) {
  Trail trail(5, 0.5);
  drive(trail, 0.0, 10.0, 0.125);
  const nav_msgs::Path& path = trail.path();
  EXPECT_EQ(path.header.frame_id, "map");
  EXPECT_EQ(path.header.stamp.toSec(), 110.0);
  ASSERT_EQ(path.poses.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(path.poses[i].pose.position.x, 8.0 + 0.5 * static_cast<double>(i));
}

TEST(Trail, StartsAfresh) {
  Trail trail(5, 0.5);
  drive(trail, 0.0, 10.0, 1.0);
  trail.clear();
  EXPECT_TRUE(trail.path().poses.empty());
}

}  // namespace
}  // namespace multipath_localization
