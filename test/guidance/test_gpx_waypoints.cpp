#include "guidance/gpx_waypoints.hpp"
#include "waypoint_file_test.hpp"

namespace multipath_localization {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using GpxWaypoints = WaypointFileTest;

std::string gpx(const std::string& content) {
  return "<gpx xmlns=\"http://www.topografix.com/GPX/1/1\" version=\"1.1\">\n" + content + "</gpx>";
}

const std::string kWaypoints =
    "<wpt lat=\"1\" lon=\"2\"><name>gate</name></wpt>\n<wpt lat=\"3\" lon=\"4\"/>\n";
const std::string kTrack =
    "<trk><trkseg><trkpt lat=\"5\" lon=\"6\"><ele>3</ele></trkpt></trkseg>"
    "<trkseg><trkpt lat=\"7\" lon=\"8\"/></trkseg></trk>\n";
const std::string kRoute = "<rte><rtept lat=\"35\" lon=\"139\"/><rtept lat=\"35.5\" lon=\"139.25\"/></rte>\n";

TEST_F(GpxWaypoints, AreTheRouteElseTheTrackElseTheWaypoints) {
  EXPECT_EQ(places("a.gpx", gpx(kWaypoints + kTrack + kRoute)), (Points{{35.0, 139.0}, {35.5, 139.25}}));
  EXPECT_EQ(places("a.gpx", gpx(kWaypoints + kTrack)), (Points{{5.0, 6.0}, {7.0, 8.0}}));
  EXPECT_EQ(places("a.gpx", gpx(kWaypoints)), (Points{{1.0, 2.0}, {3.0, 4.0}}));
}

TEST_F(GpxWaypoints, AreRefusedByTheirLine) {
  EXPECT_EQ(refusal("a.gpx", gpx("\n<wpt lat=\"1\"/>")), ":3: a point without lat or lon");
  EXPECT_EQ(refusal("a.gpx", gpx("<wpt lat=\"1\" lon=\"east\"/>")), ":2: 'east' is not a number");
  EXPECT_EQ(refusal("a.gpx", gpx("<wpt lat=\"91\" lon=\"1\"/>")), ":2: a waypoint is no place on the Earth");
  EXPECT_EQ(refusal("a.gpx", gpx(kRoute + kRoute)), ": 2 lines: which of them is the route?");
  EXPECT_EQ(refusal("a.gpx", gpx("")), ": neither a line nor points to drive along");
}

}  // namespace
}  // namespace multipath_localization
