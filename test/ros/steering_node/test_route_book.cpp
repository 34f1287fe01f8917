#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "ros/steering_node/route_book.hpp"

namespace multipath_localization {
namespace {

constexpr double kLatitude = 35.0;
constexpr double kLongitude = 139.0;
constexpr double kDegree = 110941.0;  // of latitude there [m]

geometry_msgs::PoseStamped origin(double latitude, const std::string& frame = "map") {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = frame;
  message.pose.position.x = kLongitude;
  message.pose.position.y = latitude;
  return message;
}

geometry_msgs::PoseArray route(const std::vector<Eigen::Vector2d>& points, const std::string& frame = "map") {
  geometry_msgs::PoseArray message;
  message.header.frame_id = frame;
  for (const Eigen::Vector2d& point : points) {
    message.poses.emplace_back();
    message.poses.back().position.x = point.x();
    message.poses.back().position.y = point.y();
  }
  return message;
}

class RouteBookTest : public testing::Test {
 protected:
  WaypointMission mission_{WaypointFollowerParameters{}, {}, true};

  [[nodiscard]] std::string status() { return mission_.command({}, 0.0, Trust::kGood).status; }
  [[nodiscard]] const Eigen::Vector2d& first() const { return mission_.follower().waypoints().front(); }
};

TEST_F(RouteBookTest, PlacesWhatItIsStartedWith) {
  SteeringSettings settings;
  settings.waypoints.points = {{30.0, 0.0}};
  RouteBook book(settings, mission_);
  EXPECT_EQ(first(), Eigen::Vector2d(30.0, 0.0));
}

TEST_F(RouteBookTest, WaitsForTheOriginOfMapToPlaceLatitudeAndLongitude) {
  SteeringSettings settings;
  settings.waypoints = {true, {{kLatitude + 100.0 / kDegree, kLongitude}}};
  RouteBook book(settings, mission_);
  EXPECT_EQ(status(), "stopped: waiting for map's origin, to place waypoints by latitude and longitude");
  EXPECT_FALSE(book.take_origin(origin(kLatitude, "odom")));
  EXPECT_FALSE(book.take_origin(origin(95.0)));
  EXPECT_TRUE(book.take_origin(origin(kLatitude)));
  EXPECT_NEAR(first().y(), 100.0, 0.01);
  EXPECT_FALSE(book.take_origin(origin(kLatitude)));
}

TEST_F(RouteBookTest, KeepsWaypointsWhereTheyAreOnTheGroundWhenMapMoves) {
  RouteBook book(SteeringSettings{}, mission_);
  EXPECT_EQ(status(), "stopped: no waypoints");
  EXPECT_FALSE(book.take_origin(origin(kLatitude)));
  EXPECT_TRUE(book.take_waypoints(route({{20.0, 10.0}})));
  EXPECT_TRUE(book.take_origin(origin(kLatitude + 20.0 / kDegree)));
  EXPECT_NEAR(first().x(), 20.0, 0.01);
  EXPECT_NEAR(first().y(), -10.0, 0.01);
}

TEST_F(RouteBookTest, RefusesWaypointsOfAnotherFrameAndSuchAsCannotBeDrivenTo) {
  RouteBook book(SteeringSettings{}, mission_);
  EXPECT_TRUE(book.take_waypoints(route({{20.0, 10.0}})));
  EXPECT_FALSE(book.take_waypoints(route({{30.0, 10.0}}, "odom")));
  EXPECT_FALSE(book.take_waypoints(route({{30.0, NAN}})));
  EXPECT_FALSE(book.take_waypoints(route({20000, Eigen::Vector2d(30.0, 10.0)})));
  EXPECT_FALSE(book.take_waypoints(route({{20.0, 10.0}})));  // the same again
  EXPECT_EQ(first(), Eigen::Vector2d(20.0, 10.0));
}

TEST_F(RouteBookTest, KeepsWhatIsRecordedWhenItIsSaved) {
  SteeringSettings settings;
  RouteBook without_file(settings, mission_);
  EXPECT_FALSE(without_file.record({1.0, 2.0}).done);
  settings.parameters.waypoint_file = testing::TempDir() + "route_book_test.yaml";
  std::remove(settings.parameters.waypoint_file.c_str());
  RouteBook book(settings, mission_);
  EXPECT_EQ(book.save().message, "nothing is recorded");
  EXPECT_EQ(book.record({1.0, 2.0}).message, "waypoint 1, to be kept by save");
  EXPECT_FALSE(book.record({NAN, 2.0}).done);
  EXPECT_TRUE(book.save().done);
  EXPECT_EQ(read_waypoints(settings.parameters.waypoint_file)->points.size(), 1U);
  EXPECT_EQ(status(), "stopped: by order, waiting for start");
  EXPECT_TRUE(mission_.start().done);
  EXPECT_EQ(first(), Eigen::Vector2d(1.0, 2.0));
  std::remove(settings.parameters.waypoint_file.c_str());
}

}  // namespace
}  // namespace multipath_localization
