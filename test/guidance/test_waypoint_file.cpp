#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "../core/german_locale.hpp"
#include "guidance/waypoint_reading.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/guidance/waypoint_file.hpp"
#include "waypoint_file_test.hpp"

namespace multipath_localization {
namespace {

namespace fs = std::filesystem;
using Points = std::vector<Eigen::Vector2d>;

using WaypointFile = WaypointFileTest;

TEST_F(WaypointFile, RefusesMoreThanItsBounds) {
  std::string many = "x,y\n";
  for (std::size_t i = 0; i < kMostWaypoints; ++i) many += "1,2\n";
  EXPECT_EQ(refusal("a.csv", many), "");
  EXPECT_EQ(refusal("a.csv", many + "1,2\n"), ":10002: more than 10000 waypoints");
  EXPECT_EQ(refusal("a.csv", std::string(4000001, '#')), ": larger than 4000000 bytes");
}

TEST_F(WaypointFile, RefusesWhatIsNoFileOfWaypoints) {
  EXPECT_FALSE(read_waypoints(folder_ / "missing.csv").has_value());
  EXPECT_THROW(read_waypoints(folder_ / "missing.txt"), ParameterError);
  EXPECT_EQ(
      refusal("a.txt", "x,y\n"),
      ": a file of waypoints ends in .csv, .yaml, .yml, .geojson, .json, .kml, .gpx, .plan or .waypoints");
  fs::create_directories(folder_ / "folder.csv");
  EXPECT_THROW(read_waypoints(folder_ / "folder.csv"), ParameterError);
}

TEST_F(WaypointFile, WritesWhatItReads) {
  for (const char* name : {"a.csv", "a.yaml"}) {
    for (const bool on_earth : {false, true}) {
      const WaypointList list{on_earth, {{35.123456789, -139.5}, {-0.25, 7.0}}};
      write_waypoints(folder_ / name, list);
      const WaypointList read = read_waypoints(folder_ / name).value();
      EXPECT_EQ(read.on_earth, on_earth);
      ASSERT_EQ(read.points.size(), 2U);
      EXPECT_LT((read.points[0] - list.points[0]).norm(), on_earth ? 1e-9 : 1e-4);
      EXPECT_EQ(read.points[1], list.points[1]);
    }
  }
}

TEST_F(WaypointFile, IsWrittenAndReadAlikeInAnyLocale) {
  const WaypointList list{false, {{1234.5, -0.25}}};
  const GermanLocale german;
  for (const char* name : {"a.csv", "a.yaml"}) {
    write_waypoints(folder_ / name, list);
    EXPECT_EQ(read_waypoints(folder_ / name).value().points, list.points);
  }
  std::ifstream file(folder_ / "a.csv");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "x,y\n1234.5000,-0.2500\n");
}

TEST_F(WaypointFile, RefusesToWriteAnotherEnding) {
  EXPECT_THROW(write_waypoints(folder_ / "a.txt", {}), ParameterError);
  EXPECT_THROW(write_waypoints(folder_ / "a.gpx", {true, {{35.0, 139.0}}}), ParameterError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.gpx"));
}

TEST(MapFeatures, AreARouteByTheirOnlyLineOrTheirPoints) {
  const FilePlace where{"file"};
  MapFeatures features("file");
  EXPECT_THROW(features.route(), ParameterError) << "nothing";
  features.add_point({1.0, 2.0}, where);
  features.add_point({3.0, 4.0}, where);
  EXPECT_EQ(features.route().points, (Points{{1.0, 2.0}, {3.0, 4.0}}));
  features.begin_line();
  for (const double latitude : {5.0, 6.0, 5.0}) features.add_to_line({latitude, 7.0}, where);
  EXPECT_EQ(features.route().points, (Points{{5.0, 7.0}, {6.0, 7.0}, {5.0, 7.0}}));
  features.close_ring();
  EXPECT_EQ(features.route().points, (Points{{5.0, 7.0}, {6.0, 7.0}}));
  features.begin_line();
  EXPECT_THROW(features.route(), ParameterError) << "two lines";
  EXPECT_THROW(features.add_point({91.0, 0.0}, where), ParameterError);
}

TEST(WaypointList, LiesInMapByTheDatum) {
  const LocalFrame map(Geodetic{35.0, 139.0, 40.0});
  const Geodetic place = map.to_geodetic({30.0, -20.0});
  const Points points = to_map({true, {{place.latitude_deg, place.longitude_deg}}}, map);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_LT((points[0] - Eigen::Vector2d(30.0, -20.0)).norm(), 1e-3);
  EXPECT_EQ(to_map({false, {{1.0, 2.0}}}, std::nullopt), (Points{{1.0, 2.0}}));
  EXPECT_THROW(to_map({true, {{35.0, 139.0}}}, std::nullopt), std::invalid_argument);
}

TEST(WaypointList, TakesPointsOfMapByLatitudeAndLongitudeWhereItCan) {
  const std::optional<LocalFrame> map(Geodetic{35.0, 139.0, 40.0});
  WaypointList list;
  append(list, {30.0, -20.0}, map);
  append(list, {-7.0, 4.0}, map);
  EXPECT_TRUE(list.on_earth);
  const Points points = to_map(list, map);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_LT((points[0] - Eigen::Vector2d(30.0, -20.0)).norm(), 1e-3);
  EXPECT_LT((points[1] - Eigen::Vector2d(-7.0, 4.0)).norm(), 1e-3);
  EXPECT_THROW(append(list, {1.0, 2.0}, std::nullopt), std::invalid_argument);
}

TEST(WaypointList, StaysInMapWhereItBeganThere) {
  WaypointList list;
  append(list, {1.0, 2.0}, std::nullopt);
  append(list, {3.0, 4.0}, LocalFrame(Geodetic{35.0, 139.0, 40.0}));
  EXPECT_FALSE(list.on_earth);
  EXPECT_EQ(list.points, (Points{{1.0, 2.0}, {3.0, 4.0}}));
}

/// Where `point` of `a` is in `b`.
Eigen::Vector2d seen(const LocalFrame& a, const Eigen::Vector2d& point, const LocalFrame& b) {
  return b.to_map(a.to_geodetic(point));
}

TEST(WaypointList, StaysWhereItIsOnTheGroundWhenMapMoves) {
  const LocalFrame here(Geodetic{60.0, 139.0, 40.0});
  const LocalFrame there(here.to_geodetic({-3000.0, 500.0}));
  const WaypointList list{false, {{30.0, -20.0}, {-7.0, 400.0}}, here};
  const WaypointList result = moved(list, there);
  EXPECT_EQ(to_map(list, there), result.points);
  EXPECT_LT((there.origin() - result.map->origin()).norm(), 1e-9);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((result.points[i] - seen(here, list.points[i], there)).norm(), 1e-3);
    EXPECT_GT((result.points[i] - list.points[i] - Eigen::Vector2d(3000.0, -500.0)).norm(), 0.01)
        << "north is another there";
    EXPECT_LT((moved(result, here).points[i] - list.points[i]).norm(), 1e-3);
  }
}

TEST(WaypointList, StaysAsItIsWhereAMapIsNotKnownOrTheSame) {
  const LocalFrame map(Geodetic{35.0, 139.0, 40.0});
  const Points points{{1.0, 2.0}, {0.1, 4.0}};
  EXPECT_EQ(moved({false, points}, map).points, points);
  EXPECT_EQ(moved({false, points, map}, std::nullopt).points, points);
  EXPECT_EQ(moved({false, points, map}, map).points, points);
  EXPECT_EQ(moved({true, points}, map).points, points);
}

TEST(WaypointList, RefusesToMoveFartherThanMapReaches) {
  const LocalFrame here(Geodetic{35.0, 139.0, 40.0});
  const LocalFrame there(Geodetic{35.95, 139.0, 40.0});  // 105 km
  EXPECT_THROW(moved({false, {{0.0, 90e3}, {1.0, 2.0}}, here}, there), std::invalid_argument);
  EXPECT_EQ(moved({false, {{0.0, 90e3}}, here}, there).points.size(), 1U);
}

TEST(WaypointList, AppendsInTheMapOfTheDay) {
  const LocalFrame here(Geodetic{35.0, 139.0, 40.0});
  const LocalFrame there(here.to_geodetic({0.0, 50.0}));
  WaypointList list{false, {{10.0, 0.0}}, here};
  append(list, {20.0, 0.0}, there);
  ASSERT_EQ(list.points.size(), 2U);
  EXPECT_LT((list.points[0] - Eigen::Vector2d(10.0, -50.0)).norm(), 1e-3);
  EXPECT_EQ(list.points[1], Eigen::Vector2d(20.0, 0.0));
  EXPECT_THROW(append(list, {1.0, 2.0}, LocalFrame(Geodetic{45.0, 139.0, 40.0})), std::invalid_argument);
  EXPECT_EQ(list.points.size(), 2U);
}

TEST(WaypointList, TakesNoPointThatCannotBeDrivenTo) {
  WaypointList list;
  EXPECT_THROW(append(list, {1e9, 0.0}, std::nullopt), std::invalid_argument);
  EXPECT_TRUE(list.points.empty());
  list.points.resize(kMostWaypoints, Eigen::Vector2d::Zero());
  EXPECT_THROW(append(list, {1.0, 2.0}, std::nullopt), std::invalid_argument);
}

TEST(WaypointList, RefusesAPlaceThatMapCannotHold) {
  const LocalFrame map(Geodetic{35.0, 139.0, 0.0});
  EXPECT_THROW(to_map({true, {{35.0, 139.0}, {35.0, 141.0}}}, map), std::invalid_argument);
  EXPECT_THROW(to_map({false, {{1.0, 2.0}, {1.1e5, 0.0}}}, map), std::invalid_argument);
  EXPECT_THROW(to_map({false, {{std::nan(""), 0.0}}}, map), std::invalid_argument);
}

TEST(WaypointList, HasAnEnd) {
  WaypointList list{false, Points(kMostWaypoints, Eigen::Vector2d::Zero())};
  EXPECT_EQ(to_map(list, std::nullopt).size(), kMostWaypoints);
  list.points.emplace_back(1.0, 2.0);
  EXPECT_THROW(to_map(list, std::nullopt), std::invalid_argument);
}

}  // namespace
}  // namespace multipath_localization
