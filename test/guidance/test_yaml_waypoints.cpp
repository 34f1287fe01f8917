#include "waypoint_file_test.hpp"

namespace multipath_localization {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using YamlWaypoints = WaypointFileTest;

TEST_F(YamlWaypoints, ReadsTheFormsOfYaml) {
  const WaypointList map =
      read_waypoints(holding("a.yaml", "waypoints:\n  - [1, 2]\n  - {x: 3, y: 4}\n")).value();
  EXPECT_FALSE(map.on_earth);
  EXPECT_EQ(map.points, (Points{{1.0, 2.0}, {3.0, 4.0}}));
  const WaypointList earth =
      read_waypoints(holding("a.yml", "waypoints:\n  - {longitude: 139.25, latitude: 35.5}\n")).value();
  EXPECT_TRUE(earth.on_earth);
  EXPECT_EQ(earth.points, (Points{{35.5, 139.25}}));
}

TEST_F(YamlWaypoints, RefusesABadLineOfYamlByItsNumber) {
  const std::string forms = ": a waypoint is [x, y], {x: , y: } or {latitude: , longitude: }";
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - [1, 2]\n  - [1, 2, 3]\n"), ":3" + forms);
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - {x: 1, latitude: 3}\n"), ":2" + forms);
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - 7\n"), ":2" + forms);
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - [1, .nan]\n"), ":2: a waypoint is not finite");
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - [1, 2]\n  - {latitude: 1, longitude: 2}\n"),
            ":3: a point of map among such on Earth, or the reverse");
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - [1, two]\n").rfind(":2: ", 0), 0U);
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - [1, 2\n").rfind(":3: ", 0), 0U);
  for (const char* other : {"", "[[1, 2]]", "waypoints: 3", "waypoints: [[1, 2]]\nloop: true"}) {
    EXPECT_EQ(refusal("a.yaml", other), ":1: the file holds a list named waypoints and nothing else");
  }
}

}  // namespace
}  // namespace multipath_localization
