#include <cmath>

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

TEST_F(YamlWaypoints, HoldsWhatIsToBeDoneAtWaypoints) {
  const std::string file = holding("a.yaml",
                                   "waypoints:\n  - [0, 0]\n  - {x: 1, y: 2, speed: 0.5, wait: 10}\n"
                                   "  - {x: 3, y: 4, wait: resume, reverse: true}\n");
  for (int written = 0; written < 2; ++written) {
    const WaypointList list = read_waypoints(file).value();
    ASSERT_EQ(list.tasks.size(), 3U);
    EXPECT_TRUE(std::isinf(list.tasks[0].speed));
    EXPECT_EQ(list.tasks[0].wait, 0.0);
    EXPECT_EQ(list.tasks[1].speed, 0.5);
    EXPECT_EQ(list.tasks[1].wait, 10.0);
    EXPECT_FALSE(list.tasks[1].reverse);
    EXPECT_TRUE(std::isinf(list.tasks[2].wait));
    EXPECT_TRUE(list.tasks[2].reverse);
    write_waypoints(file, list);
    EXPECT_THROW(write_waypoints(file + ".csv", list), ParameterError);
  }
  EXPECT_TRUE(read_waypoints(holding("b.yaml", "waypoints: [[1, 2]]"))->tasks.empty());
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
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - {x: 1, y: 2, sped: 3}\n"),
            ":2" + forms + ", with speed, wait and reverse as wanted");
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - {x: 1, y: 2, wait: -3}\n"), ":2: wait is a number above 0");
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - {x: 1, y: 2, speed: .inf}\n"),
            ":2: speed is a number above 0");
  EXPECT_EQ(refusal("a.yaml", "waypoints:\n  - {x: 1, y: 2, reverse: 3}\n").rfind(":2: ", 0), 0U);
  for (const char* other : {"", "[[1, 2]]", "waypoints: 3", "waypoints: [[1, 2]]\nloop: true"}) {
    EXPECT_EQ(refusal("a.yaml", other),
              ":1: the file holds a list named waypoints, or a field, and nothing else");
  }
}

TEST_F(YamlWaypoints, HoldsAField) {
  const std::string border = "field:\n  border: [[0, 0], [40, 0], [40, 25]]\n";
  const WaypointList list =
      read_waypoints(holding("a.yaml", border + "  width: 1.2\n  heading: 0.5\n  start: 3\n  speed: 0.8\n"))
          .value();
  EXPECT_EQ(list.points, (Points{{0.0, 0.0}, {40.0, 0.0}, {40.0, 25.0}}));
  ASSERT_TRUE(list.field);
  EXPECT_EQ(list.field->width, 1.2);
  EXPECT_EQ(list.field->heading, 0.5);
  EXPECT_EQ(list.field->start, 2U);
  EXPECT_EQ(list.field->speed, 0.8);
  EXPECT_FALSE(read_waypoints(holding("b.yaml", border + "  width: 2\n"))->field->start);
}

TEST_F(YamlWaypoints, RefusesABadFieldByItsLine) {
  const std::string border = "field:\n  border: [[0, 0], [40, 0], [40, 25]]\n";
  const std::string form =
      "a field has a border, a list of corners, and a width, and heading, start and speed as wanted";
  EXPECT_EQ(refusal("a.yaml", border), ":2: " + form);
  EXPECT_EQ(refusal("a.yaml", border + "  width: 1\n  with: 2\n"), ":2: " + form);
  EXPECT_EQ(refusal("a.yaml", border + "  width: 0\n"), ":2: width is a number above 0");
  EXPECT_EQ(refusal("a.yaml", border + "  width: 1\n  start: 4\n"),
            ":2: start is the number of a corner, 1 being the first");
  EXPECT_EQ(refusal("a.yaml", "field:\n  width: 1\n  border: [[0, 0], [9, 9], [9, 0], [0, 9]]\n"),
            ":2: the border of the field has edges that cross or touch");
  EXPECT_EQ(refusal("a.yaml", "field:\n  width: 1\n  border: [{x: 0, y: 0, wait: 2}, [9, 9], [9, 0]]\n"),
            ":2: a corner of a field has coordinates alone");
}

}  // namespace
}  // namespace multipath_localization
