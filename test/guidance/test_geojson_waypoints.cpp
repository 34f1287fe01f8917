#include "guidance/geojson_waypoints.hpp"
#include "guidance/json_file.hpp"
#include "waypoint_file_test.hpp"

namespace multipath_localization {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using GeoJsonWaypoints = WaypointFileTest;

const char* const kLine = R"({"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"name": "gate"}, "geometry": {"type": "Point", "coordinates": [139.5, 35.5]}},
  {"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[139, 35, 12.5], [139.25, 35]]}}]})";

std::string feature(const std::string& type, const std::string& coordinates) {
  return R"({"type": "Feature", "geometry": {"type": ")" + type + R"(", "coordinates": )" + coordinates +
         "}}";
}

TEST_F(GeoJsonWaypoints, AreItsLineLongitudeFirst) {
  EXPECT_EQ(places("a.geojson", kLine), (Points{{35.0, 139.0}, {35.0, 139.25}}));
}

TEST_F(GeoJsonWaypoints, AreItsPointsWhereThereIsNoLine) {
  EXPECT_EQ(places("a.json", feature("MultiPoint", "[[1, 2], [3, 4]]")), (Points{{2.0, 1.0}, {4.0, 3.0}}));
  EXPECT_EQ(places("a.json", R"({"type": "Point", "coordinates": [1, 2]})"), (Points{{2.0, 1.0}}));
}

TEST_F(GeoJsonWaypoints, AreTheOuterRingOfAPolygonWithoutItsEnd) {
  EXPECT_EQ(places("a.geojson", feature("Polygon", "[[[0, 0], [1, 0], [1, 1], [0, 0]], [[5, 5]]]")),
            (Points{{0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}));
}

TEST_F(GeoJsonWaypoints, AreRefusedByTheirFeature) {
  EXPECT_EQ(refusal("a.geojson", feature("LineString", "[[139, 35], [139, 95]]")),
            ": a waypoint is no place on the Earth");
  EXPECT_EQ(refusal("a.geojson", feature("LineString", "[[139, \"35\"]]")), ": a coordinate is not a number");
  EXPECT_EQ(refusal("a.geojson", feature("LineString", "[[139]]")), ": a coordinate is not a number");
  EXPECT_EQ(refusal("a.geojson", feature("LineString", "3")), ": no list of coordinates");
  EXPECT_EQ(refusal("a.geojson", feature("LineString", "[]")), ": neither a line nor points to drive along");
  EXPECT_EQ(refusal("a.geojson", feature("Polygon", "[]")), ": a polygon without a ring");
  EXPECT_EQ(refusal("a.geojson", R"({"type": "FeatureCollection", "features": [)" +
                                     feature("Point", "[1, 2]") + "," + feature("MultiPolygon", "[]") + "]}"),
            ":feature 2: neither a LineString, Polygon, Point nor MultiPoint but MultiPolygon");
  EXPECT_EQ(refusal("a.geojson", R"({"type": "FeatureCollection", "features": [)" +
                                     feature("LineString", "[[1, 2]]") + "," +
                                     feature("LineString", "[[1, 2]]") + "]}"),
            ": 2 lines: which of them is the route?");
  EXPECT_EQ(refusal("a.geojson", R"({"type": "FeatureCollection"})"), ": no list of features");
  EXPECT_EQ(refusal("a.geojson", "[1]"), ": neither a LineString, Polygon, Point nor MultiPoint but nothing");
}

TEST_F(GeoJsonWaypoints, OfAnotherReferenceSystemAreRefused) {
  const auto in_system = [](const std::string& name) {
    return R"({"type": "Point", "coordinates": [1, 2], "crs": {"type": "name", "properties": {"name": ")" +
           name + "\"}}}";
  };
  EXPECT_EQ(places("a.geojson", in_system("urn:ogc:def:crs:OGC:1.3:CRS84")).size(), 1U);
  EXPECT_EQ(
      refusal("a.geojson", in_system("urn:ogc:def:crs:EPSG::25832")).rfind(": its coordinates are not", 0),
      0U);
}

TEST_F(GeoJsonWaypoints, ThatAreNoJsonAreRefusedByTheirLine) {
  EXPECT_NE(refusal("a.geojson", "{\n\"type\": }").find("line 2"), std::string::npos);
  EXPECT_EQ(refusal("a.geojson", std::string(100000, '[')), ": nested over 64 deep");
  EXPECT_NE(refusal("a.geojson", R"({"type": "Point", "coordinates": [1e999, 2]})"), "");
}

TEST_F(GeoJsonWaypoints, AreWrittenAsTheyAreRead) {
  for (const Points& points : {Points{{35.123456789, -139.5}, {-0.25, 7.0}}, Points{{35.5, 139.0}}}) {
    write_waypoints(folder_ / "a.geojson", {true, points});
    const WaypointList read = read_waypoints(folder_ / "a.geojson").value();
    ASSERT_EQ(read.points.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT((read.points[i] - points[i]).norm(), 1e-9);
  }
  const LocalFrame map(Geodetic{35.0, 139.0, 40.0});
  EXPECT_NE(geojson_of({false, {{0.0, 0.0}}, map}).find("[139.000000000, 35.000000000]"), std::string::npos);
  EXPECT_THROW(geojson_of({false, {{0.0, 0.0}}}), ParameterError) << "no one knows where x and y are";
  EXPECT_THROW(geojson_of({true, {}}), ParameterError);
}

TEST_F(GeoJsonWaypoints, AreTheBorderOfAFieldWhereAPolygonHasAWidth) {
  const auto polygon = [](const std::string& properties, const std::string& rings) {
    return R"({"type": "Feature", "properties": )" + properties +
           R"(, "geometry": {"type": "Polygon", "coordinates": )" + rings + "}}";
  };
  const std::string ring = "[[139.0, 35.0], [139.001, 35.0], [139.001, 35.001], [139.0, 35.0]]";
  const std::string width = R"({"coverage_width": 1.5})";
  const WaypointList list = read_waypoints(holding("a.geojson", polygon(width, "[" + ring + "]"))).value();
  ASSERT_TRUE(list.field);
  EXPECT_EQ(list.field->width, 1.5);
  EXPECT_EQ(list.points.size(), 3U);
  EXPECT_FALSE(read_waypoints(holding("b.geojson", polygon("{}", "[" + ring + "]")))->field);
  EXPECT_EQ(refusal("a.geojson", polygon(R"({"coverage_width": "wide"})", "[" + ring + "]")),
            ": coverage_width is a number above 0");
  EXPECT_EQ(refusal("a.geojson", polygon(width, "[" + ring + ", " + ring + "]")), ": a field with holes");
  EXPECT_EQ(refusal("a.geojson", polygon(width, "[[[1, 1], [2, 2], [2, 1], [1, 2], [1, 1]]]")),
            ": the border of the field has edges that cross or touch");
}

}  // namespace
}  // namespace multipath_localization
