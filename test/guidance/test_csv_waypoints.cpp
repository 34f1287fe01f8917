#include "waypoint_file_test.hpp"

namespace multipath_localization {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using CsvWaypoints = WaypointFileTest;

TEST_F(CsvWaypoints, ReadsMapPointsOfCsv) {
  const WaypointList list =
      read_waypoints(holding("a.csv", "# field\nx,y\n1,2\n\n-3.5 , 4e1 # gate\n")).value();
  EXPECT_FALSE(list.on_earth);
  EXPECT_EQ(list.points, (Points{{1.0, 2.0}, {-3.5, 40.0}}));
}

TEST_F(CsvWaypoints, ReadsPlacesOfACsvFromASpreadsheet) {
  const WaypointList list =
      read_waypoints(holding("a.csv", "\xEF\xBB\xBFlatitude,longitude\r\n35.5,139.25\r\n")).value();
  EXPECT_TRUE(list.on_earth);
  EXPECT_EQ(list.points, (Points{{35.5, 139.25}}));
}

TEST_F(CsvWaypoints, RefusesABadLineOfCsvByItsNumber) {
  EXPECT_EQ(refusal("a.csv", "x,y\n1,2\n3\n"), ":3: 1 cells instead of 2");
  EXPECT_EQ(refusal("a.csv", "x,y\n1,2,3\n"), ":2: 3 cells instead of 2");
  EXPECT_EQ(refusal("a.csv", "x,y\n1,two\n"), ":2: 'two' is not a number");
  EXPECT_EQ(refusal("a.csv", "x,y\n1,\n"), ":2: '' is not a number");
  EXPECT_EQ(refusal("a.csv", std::string("x,y\n1\0e9,2\n", 11)).rfind(":2: '1", 0), 0U) << "a zero byte";
  EXPECT_EQ(refusal("a.csv", "x,y\nnan,1\n"), ":2: a waypoint is not finite");
  EXPECT_EQ(refusal("a.csv", "x,y\n1,1e9\n"), ":2: a waypoint is farther than 100 km from map's origin");
  EXPECT_EQ(refusal("a.csv", "latitude,longitude\n35,139\n139,35\n"),
            ":3: a waypoint is no place on the Earth");
  EXPECT_EQ(refusal("a.csv", "1,2\n3,4\n"),
            ":1: the first line names the columns: x,y or latitude,longitude");
}

}  // namespace
}  // namespace multipath_localization
