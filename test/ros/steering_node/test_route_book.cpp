#include <gtest/gtest.h>

#include <cmath>
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

/// An orientation of zeros where there is no `yaw`.
geometry_msgs::Pose pose(double x, double y, std::optional<double> yaw = std::nullopt) {
  geometry_msgs::Pose message;
  message.position.x = x;
  message.position.y = y;
  if (yaw) {
    message.orientation.z = std::sin(0.5 * *yaw);
    message.orientation.w = std::cos(0.5 * *yaw);
  }
  return message;
}

geometry_msgs::PoseStamped goal(const geometry_msgs::Pose& pose, const std::string& frame = "map") {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = frame;
  message.pose = pose;
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

TEST_F(RouteBookTest, TakesAGoalOfRvizToDriveToOnce) {
  RouteBook book(SteeringSettings{}, mission_);
  EXPECT_FALSE(book.take_goal(goal(pose(5.0, 5.0), "odom"), std::nullopt));
  EXPECT_FALSE(book.take_goal(goal(pose(NAN, 5.0)), std::nullopt));
  EXPECT_TRUE(book.take_goal(goal(pose(5.0, 5.0)), std::nullopt));
  EXPECT_EQ(first(), Eigen::Vector2d(5.0, 5.0));
  EXPECT_TRUE(mission_.follower().route().tasks().once);
  EXPECT_FALSE(mission_.follower().route().tasks().final_heading);
  EXPECT_TRUE(book.take_goal(goal(pose(20.0, 0.0, 1.0)), Pose2{}));
  EXPECT_EQ(mission_.follower().waypoints().size(), 2U);  // comes from where its heading points
  EXPECT_NEAR(*mission_.follower().route().tasks().final_heading, 1.0, 1e-9);
}

TEST_F(RouteBookTest, TakesAGoalByLatitudeAndLongitudeOnceMapHasAnOrigin) {
  RouteBook book(SteeringSettings{}, mission_);
  GeoPose there;
  there.position.latitude = kLatitude + 100.0 / kDegree;
  there.position.longitude = kLongitude;
  EXPECT_FALSE(book.take_goal(there, std::nullopt, ros::Time(1.0)));
  book.take_origin(origin(kLatitude));
  EXPECT_TRUE(book.take_goal(there, std::nullopt, ros::Time(1.0)));
  EXPECT_NEAR(first().y(), 100.0, 0.01);
  there.position.latitude = 95.0;
  EXPECT_FALSE(book.take_goal(there, std::nullopt, ros::Time(1.0)));
  there.position.latitude = NAN;
  EXPECT_FALSE(book.take_goal(there, std::nullopt, ros::Time(1.0)));
  EXPECT_NEAR(first().y(), 100.0, 0.01);
}

TEST_F(RouteBookTest, TakesThePlanOfAPlanner) {
  RouteBook book(SteeringSettings{}, mission_);
  nav_msgs::Path plan;
  plan.header.frame_id = "map";
  for (int i = 0; i <= 40; ++i) plan.poses.push_back(goal(pose(0.5 * i, 0.0, 0.0)));
  EXPECT_TRUE(book.take_plan(plan));
  EXPECT_EQ(mission_.follower().waypoints().size(), 41U);
  EXPECT_TRUE(mission_.follower().route().tasks().once);
  plan.header.frame_id = "odom";
  plan.poses.pop_back();
  EXPECT_FALSE(book.take_plan(plan));
}

TEST_F(RouteBookTest, KeepsWhatIsToBeDoneOnAMovedMap) {
  RouteBook book(SteeringSettings{}, mission_);
  book.take_origin(origin(kLatitude));
  EXPECT_TRUE(book.take_goal(goal(pose(5.0, 5.0)), std::nullopt));
  EXPECT_TRUE(book.take_origin(origin(kLatitude + 3.0)));  // it is out of reach there
  EXPECT_TRUE(book.take_origin(origin(kLatitude)));
  EXPECT_NEAR(first().y(), 5.0, 0.01);
  EXPECT_TRUE(mission_.follower().route().tasks().once);
}

}  // namespace
}  // namespace multipath_localization
