#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "ros/steering_node/steering_node.hpp"

namespace multipath_localization {
namespace {

TEST(SteeringNode, ConfigFileHoldsTheDefaults) {
  std::stringstream text;
  text << std::ifstream(std::string(CONFIG_DIR) + "/steering.yaml").rdbuf();
  EXPECT_EQ(text.str(), describe(SteeringNodeParameters{}));
}

TEST(SteeringNode, ReadsWaypointsBesideItsParameters) {
  const auto settings =
      SteeringSettings::from(YAML::Load("{cruise_speed: 0.7, waypoints: [[1, 2], [3.5, -4]]}"));
  EXPECT_EQ(settings.parameters.follower.cruise_speed, 0.7);
  ASSERT_EQ(settings.waypoints.points.size(), 2U);
  EXPECT_EQ(settings.waypoints.points[1], Eigen::Vector2d(3.5, -4.0));
  EXPECT_TRUE(SteeringSettings::from(YAML::Node()).waypoints.points.empty());
}

TEST(SteeringNode, ReadsAFileOfWaypointsAndRefusesABadOne) {
  const std::string file = testing::TempDir() + "steering_node_test.csv";
  std::ofstream(file) << "latitude,longitude\n35.5,139.25\n";
  const YAML::Node source = YAML::Load("{waypoint_file: " + file + "}");
  EXPECT_TRUE(SteeringSettings::from(source).waypoints.on_earth);
  EXPECT_EQ(SteeringSettings::from(source).waypoints.points.size(), 1U);
  EXPECT_THROW(SteeringSettings::from(YAML::Load("{waypoints: [[1, 2]], waypoint_file: " + file + "}")),
               ParameterError);
  std::ofstream(file) << "latitude,longitude\n35.5\n";
  EXPECT_THROW(SteeringSettings::from(source), ParameterError);
  std::remove(file.c_str());
  EXPECT_TRUE(SteeringSettings::from(source).waypoints.points.empty());
}

TEST(SteeringNode, RefusesParametersNobodyReads) {
  EXPECT_THROW(SteeringSettings::from(YAML::Load("{cruise_sped: 0.7}")), ParameterError);
  EXPECT_THROW(SteeringSettings::from(YAML::Load("{waypoints: [1, 2]}")), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
