#include <gtest/gtest.h>

#include <fstream>

#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/evaluation/scenario.hpp"

namespace multipath_localization {
namespace {

Scenario shipped(const std::string& name) {
  return load_scenario(std::string(CONFIG_DIR) + "/scenarios/" + name + ".yaml");
}

Scenario written(const std::string& text) {
  const std::string file = testing::TempDir() + "scenario_under_test.yaml";
  std::ofstream(file) << text;
  return load_scenario(file);
}

class ShippedScenario : public testing::TestWithParam<const char*> {};

TEST_P(ShippedScenario, LoadsAndRuns) {
  const Scenario scenario = shipped(GetParam());
  EXPECT_EQ(scenario.name, GetParam());
  EXPECT_GE(scenario.waypoints.size(), 4U);
  EXPECT_EQ(scenario.steering.wheelbase, scenario.simulator.robot.wheelbase);
  EXPECT_EQ(scenario.steering.max_steering_angle, scenario.simulator.robot.max_steering_angle);
  EXPECT_LE(scenario.steering.cruise_speed, scenario.simulator.robot.max_speed);
}

TEST_P(ShippedScenario, TellsEstimatorsOnlyWhatTheyRead) {
  for (const auto& entry : shipped(GetParam()).localization) {
    EXPECT_NE(make_estimator(entry.first.as<std::string>(), entry.second, 1), nullptr);
  }
}

/// Steered by the truth, the robot gets round, through open sky and shadow.
TEST_P(ShippedScenario, IsDrivenRoundByItsOwnSteering) {
  const Scenario scenario = shipped(GetParam());
  Simulator simulator(scenario.simulator, 1);
  WaypointFollower follower(scenario.steering, scenario.waypoints);
  int shadow = 0;
  int steps = 0;
  for (; simulator.time() < scenario.duration; ++steps) {
    simulator.step(follower.command(simulator.truth(), 0.0, Trust::kGood).command);
    shadow += simulator.in_shadow() ? 1 : 0;
  }
  EXPECT_GE(follower.laps(), 2);
  EXPECT_GT(shadow, 0.25 * steps);
  EXPECT_LT(shadow, 0.6 * steps);
}

INSTANTIATE_TEST_SUITE_P(Scenario, ShippedScenario, testing::Values("nishida", "street", "loop"));

TEST(Scenario, HasWhatItsFileSays) {
  const Scenario scenario = written(
      "duration: 12\nsimulator: {time_step: 0.05}\nsteering: {loop: false, waypoints: [[1, 2], [3, 4.5]]}\n"
      "localization: {gated_ekf: {gate: 9}}\n");
  EXPECT_EQ(scenario.duration, 12.0);
  EXPECT_EQ(scenario.simulator.time_step, 0.05);
  EXPECT_FALSE(scenario.steering.loop);
  ASSERT_EQ(scenario.waypoints.size(), 2U);
  EXPECT_EQ(scenario.waypoints[1], Eigen::Vector2d(3.0, 4.5));
  EXPECT_EQ(scenario.localization["gated_ekf"]["gate"].as<int>(), 9);
}

TEST(Scenario, MayLeaveEverythingToDefaults) {
  const Scenario scenario = written("{}");
  EXPECT_TRUE(scenario.waypoints.empty());
  EXPECT_TRUE(scenario.localization.IsNull());
}

TEST(Scenario, RefusesWhatNobodyReads) {
  EXPECT_THROW(written("simulatro: {}"), ParameterError);
  EXPECT_THROW(written("simulator: {robot: {wheelbas: 1}}"), ParameterError);
  EXPECT_THROW(written("steering: {speed: 1}"), ParameterError);
  EXPECT_THROW(written("steering: {waypoints: [[1, 2, 3]]}"), ParameterError);
  EXPECT_THROW(written("steering: {waypoints: [[1, .nan]]}"), ParameterError);
  EXPECT_THROW(written("steering: {waypoints: 5}"), ParameterError);
  EXPECT_THROW(written("duration: -1"), ParameterError);
  EXPECT_THROW(written("duration: long"), ParameterError);
  EXPECT_THROW(written("- 1"), ParameterError);
  EXPECT_THROW(load_scenario("/nowhere/at_all.yaml"), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
