#include "guidance/ground_station_waypoints.hpp"
#include "waypoint_file_test.hpp"

namespace multipath_localization {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using GroundStationWaypoints = WaypointFileTest;

std::string item(int command, const std::string& latitude, const std::string& longitude) {
  return R"({"type": "SimpleItem", "command": )" + std::to_string(command) +
         R"(, "frame": 3, "params": [0, 0, 0, null, )" + latitude + ", " + longitude + ", 0]}";
}

std::string plan(const std::string& items, const std::string& fence = "") {
  return R"({"fileType": "Plan", "geoFence": {"circles": [], "polygons": [)" + fence +
         R"(]}, "mission": {"items": [)" + items + R"(]}, "rallyPoints": {"points": []}, "version": 1})";
}

TEST_F(GroundStationWaypoints, AreThoseOfAPlan) {
  EXPECT_EQ(places("a.plan", plan(item(16, "35", "139") + "," + item(16, "35.5", "139.25"))),
            (Points{{35.0, 139.0}, {35.5, 139.25}}));
}

TEST_F(GroundStationWaypoints, OfAPlanThatWouldNotBeKeptAreRefused) {
  const std::string refused = " is no waypoint (16) and would not be carried out";
  EXPECT_EQ(refusal("a.plan", plan(item(16, "35", "139") + "," + item(178, "0", "0"))),
            ":item 2: command 178" + refused);
  EXPECT_EQ(refusal("a.plan", plan(R"({"type": "ComplexItem"})")),
            ":item 1: no single waypoint but a pattern of them");
  EXPECT_EQ(refusal("a.plan", plan(item(16, "null", "0"))), ":item 1: a coordinate is not a number");
  EXPECT_EQ(refusal("a.plan", plan(item(16, "35", "139"), "{}")),
            ": its geofence would not be kept: remove it");
  EXPECT_EQ(refusal("a.plan", R"({"fileType": "Parameters"})"), ": no plan of QGroundControl");
  EXPECT_EQ(refusal("a.plan", R"({"fileType": "Plan"})"), ": no list of items");
}

std::string row(int index, int frame, int command, const std::string& place) {
  return std::to_string(index) + "\t0\t" + std::to_string(frame) + "\t" + std::to_string(command) +
         "\t0\t0\t0\t0\t" + place + "\t0\t1\n";
}

TEST_F(GroundStationWaypoints, AreThoseOfAMissionWithoutItsHome) {
  const std::string first = "QGC WPL 110\r\n";
  EXPECT_EQ(places("a.waypoints", first + row(0, 0, 16, "1\t2") + row(1, 3, 16, "35\t139") + "\n"),
            (Points{{35.0, 139.0}}));
  EXPECT_EQ(places("a.waypoints", first + row(0, 0, 16, "1\t2") + row(1, 0, 16, "35\t139")),
            (Points{{1.0, 2.0}, {35.0, 139.0}}));
}

TEST_F(GroundStationWaypoints, OfAMissionAreRefusedByTheirLine) {
  const std::string first = "QGC WPL 110\n";
  EXPECT_EQ(refusal("a.waypoints", "35 139\n"), ":1: the first line is not QGC WPL 110");
  EXPECT_EQ(refusal("a.waypoints", first + "0\t1\n"), ":2: 2 cells instead of 12");
  EXPECT_EQ(refusal("a.waypoints", first + row(0, 3, 16, "35\t139") + row(1, 3, 20, "0\t0")),
            ":3: command 20 is no waypoint (16) and would not be carried out");
  EXPECT_EQ(refusal("a.waypoints", first + row(0, 3, 16, "north\t139")), ":2: 'north' is not a number");
}

}  // namespace
}  // namespace multipath_localization
