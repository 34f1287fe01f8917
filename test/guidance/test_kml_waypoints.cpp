#include "guidance/kml_waypoints.hpp"
#include "guidance/xml_file.hpp"
#include "waypoint_file_test.hpp"

namespace multipath_localization {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using KmlWaypoints = WaypointFileTest;

std::string document(const std::string& placemarks) {
  return "<?xml version=\"1.0\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Folder>\n" +
         placemarks + "</Folder></Document></kml>";
}

std::string placemark(const std::string& shape, const std::string& coordinates) {
  return "<Placemark><" + shape + "><coordinates>" + coordinates + "</coordinates></" + shape +
         "></Placemark>\n";
}

TEST_F(KmlWaypoints, AreItsLine) {
  EXPECT_EQ(places("a.kml",
                   document(placemark("Point", "1,2") + placemark("LineString", "139,35,0\n 139.25,35,0 "))),
            (Points{{35.0, 139.0}, {35.0, 139.25}}));
}

TEST_F(KmlWaypoints, AreItsPointsWhereThereIsNoLine) {
  EXPECT_EQ(places("a.kml", document(placemark("Point", "1,2,3") + placemark("Point", "3,4"))),
            (Points{{2.0, 1.0}, {4.0, 3.0}}));
  EXPECT_EQ(places("a.kml",
                   "<k:kml xmlns:k=\"http://www.opengis.net/kml/2.2\"><k:Point><k:coordinates>1,2"
                   "</k:coordinates></k:Point></k:kml>"),
            (Points{{2.0, 1.0}}));
}

TEST_F(KmlWaypoints, AreTheOuterRingOfAPolygon) {
  EXPECT_EQ(
      places("a.kml", document("<Placemark><Polygon><innerBoundaryIs><LinearRing><coordinates>9,9"
                               "</coordinates></LinearRing></innerBoundaryIs><outerBoundaryIs><LinearRing>"
                               "<coordinates>0,0 1,0 1,1 0,0</coordinates></LinearRing></outerBoundaryIs>"
                               "</Polygon></Placemark>")),
      (Points{{0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}));
}

TEST_F(KmlWaypoints, AreRefusedByTheirLine) {
  EXPECT_EQ(refusal("a.kml", document(placemark("Point", "1, 2"))), ":3: '' is not a number");
  EXPECT_EQ(refusal("a.kml", document(placemark("Point", "1;2"))), ":3: '' is not a number");
  EXPECT_EQ(refusal("a.kml", document(placemark("LineString", "1,99"))),
            ":3: a waypoint is no place on the Earth");
  EXPECT_EQ(refusal("a.kml", document(placemark("LineString", "1,2") + placemark("LineString", "1,2"))),
            ": 2 lines: which of them is the route?");
  EXPECT_EQ(refusal("a.kml", document("")), ": neither a line nor points to drive along");
  EXPECT_EQ(refusal("a.kml", "<kml>\n<Point></kml>"), ":2: XML_ERROR_MISMATCHED_ELEMENT");
  EXPECT_NE(refusal("a.kml", ""), "");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_NE(refusal("a.kml", deep), "");
}

}  // namespace
}  // namespace multipath_localization
