#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "evaluation/closed_loop.hpp"
#include "evaluation/scenario.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"

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

TEST_P(ShippedScenario, IsSteeredWithinWhatItsRobotCan) {
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
  CommandLimiter limiter(scenario.steering.limits, scenario.steering.wheelbase);
  int shadow = 0;
  int steps = 0;
  for (; simulator.time() < scenario.duration; ++steps) {
    const FollowerOutput output = follower.command(simulator.truth(), 0.0, Trust::kGood);
    simulator.step(limiter.limited(output.command, output.urgent, simulator.time_step()));
    shadow += simulator.around().in_shadow ? 1 : 0;
  }
  EXPECT_GE(follower.route().rounds(), 2);
  EXPECT_GT(shadow, 0.25 * steps);
  EXPECT_LT(shadow, 0.6 * steps);
}

/// Distance from the path, over laps, of a robot that knows where it is.
TEST(ShippedStreet, IsDrivenOnItsPathToCentimetres) {
  const Scenario scenario = shipped("street");
  Simulator simulator(scenario.simulator, 1);
  WaypointFollower follower(scenario.steering, scenario.waypoints);
  CommandLimiter limiter(scenario.steering.limits, scenario.steering.wheelbase);
  double squares = 0.0;
  double largest = 0.0;
  int steps = 0;
  for (; simulator.time() < scenario.duration; ++steps) {
    const FollowerOutput output = follower.command(simulator.truth(), 0.0, Trust::kGood);
    const PathProgress& progress = *follower.progress_on_path();
    const double station = progress.path().nearest(simulator.truth().position(), progress.station() - 1.0,
                                                   progress.station() + 1.0);
    const double offset = (progress.path().at(station).position - simulator.truth().position()).norm();
    squares += offset * offset;
    largest = std::max(largest, offset);
    simulator.step(limiter.limited(output.command, output.urgent, simulator.time_step()));
  }
  EXPECT_GE(follower.route().rounds(), 2);
  EXPECT_LT(std::sqrt(squares / steps), 0.03);
  EXPECT_LT(largest, 0.10);
}

INSTANTIATE_TEST_SUITE_P(Scenario, ShippedScenario,
                         testing::Values("nishida", "street", "loop", "parking_lot_to_buildings"));

/// RMSE in the shadow of two_stage_ekf over three seeds [m].
double shadow_rmse(const Scenario& scenario, const std::string& parameters) {
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto make = [&] { return make_estimator("two_stage_ekf", YAML::Load(parameters), seed); };
    const double rmse = *score(run_scenario(scenario, seed, make, {}).epochs, 0.0).rmse_shadow;
    squares += rmse * rmse;
  }
  return std::sqrt(squares / 3.0);
}

/// Figure 6 of [KIM].
TEST(Scenario, ParkingLotToBuildingsIsDrivenBetterByBiasCompensation) {
  const Scenario scenario = shipped("parking_lot_to_buildings");
  EXPECT_LT(shadow_rmse(scenario, "{}"), 0.5 * shadow_rmse(scenario, "compensate: false"));
}

/// As in section 5 of [SUZ]: most satellites in line of sight nearly everywhere, the plain fix off by 20 m.
TEST(ShippedCanyon, HidesFewSatellitesAndSpoilsTheFix) {
  const Scenario scenario = shipped("canyon");
  EXPECT_TRUE(scenario.steered_on_truth);
  for (const std::uint64_t seed : {1, 2, 3}) {
    Simulator simulator(scenario.simulator, seed);
    WaypointFollower follower(scenario.steering, scenario.waypoints);
    double squares = 0.0;
    int open = 0;
    int steps = 0;
    for (; simulator.time() < scenario.duration; ++steps) {
      const MotionCommand command = follower.command(simulator.truth(), 0.0, Trust::kGood).command;
      const Readings readings = simulator.step(command);
      squares += simulator.around().in_shadow ? 0.0 : simulator.around().bias.squaredNorm();
      open += simulator.around().in_shadow ? 0 : 1;
    }
    EXPECT_GE(follower.route().rounds(), 1);
    EXPECT_GT(open, 0.85 * steps);
    EXPECT_GT(std::sqrt(squares / open), 10.0);
    EXPECT_LT(std::sqrt(squares / open), 30.0);
  }
}

TEST(Scenario, HasWhatItsFileSays) {
  const Scenario scenario = written(
      "duration: 12\nsimulator: {time_step: 0.05}\nsteering: {loop: false, waypoints: [[1, 2], [3, 4.5]]}\n"
      "localization: {gated_ekf: {gate: 9}}\nsteered_on: truth\n");
  EXPECT_TRUE(scenario.steered_on_truth);
  EXPECT_EQ(scenario.duration, 12.0);
  EXPECT_EQ(scenario.simulator.time_step, 0.05);
  EXPECT_FALSE(scenario.steering.loop);
  ASSERT_EQ(scenario.waypoints.size(), 2U);
  EXPECT_EQ(scenario.waypoints[1], Eigen::Vector2d(3.0, 4.5));
  EXPECT_EQ(scenario.localization["gated_ekf"]["gate"].as<int>(), 9);
}

TEST(Scenario, PaddyDrivesTheCirclesOfThePaperAndRestsHeadingWest) {  // Table 1 of [KAM]
  const Scenario scenario = shipped("paddy");
  for (const auto& entry : scenario.localization) {
    EXPECT_NE(make_estimator(entry.first.as<std::string>(), entry.second, 1), nullptr);
  }
  SimulatorParameters without_slip = scenario.simulator;
  without_slip.robot.wheel_noise = 0.0;
  Simulator simulator(without_slip, 1);
  double turned = 0.0;
  std::size_t pairs = 0;
  while (simulator.time() < scenario.duration - 1e-6) {
    pairs += simulator.step(command_at(scenario.sequence, simulator.time(), 0.35)).measurements.size();
    EXPECT_NEAR(simulator.truth().position().norm(), 0.875, 1e-6);
    if (simulator.speed() == 0.0) continue;
    EXPECT_NEAR(simulator.speed() - 0.5 * 0.35 * simulator.yaw_rate(), 0.2, 1e-9);
    EXPECT_NEAR(simulator.speed() + 0.5 * 0.35 * simulator.yaw_rate(), 0.3, 1e-9);
    turned += simulator.yaw_rate() * simulator.time_step();
  }
  EXPECT_EQ(simulator.speed(), 0.0);
  EXPECT_GT(turned, 4.0 * kPi);
  EXPECT_LT(std::abs(angle_difference(simulator.truth().yaw, kPi)), 0.05);
  EXPECT_EQ(pairs, static_cast<std::size_t>(5.0 * scenario.duration));
}

TEST(CommandAt, RunsTheLegsInTurnAndThenStops) {
  const std::vector<SequenceLeg> sequence = {{1.0, 0.0, 0.0}, {2.0, 0.5, 0.25}};
  EXPECT_EQ(command_at(sequence, 0.0, 1.0).speed, 0.0);
  EXPECT_EQ(command_at(sequence, 0.99, 1.0).speed, 0.0);
  EXPECT_EQ(command_at(sequence, 1.0, 1.0).speed, 0.5);
  EXPECT_NEAR(yaw_rate(command_at(sequence, 2.99, 0.7), 0.7), 0.25, 1e-12);
  EXPECT_EQ(command_at(sequence, 3.0, 1.0).speed, 0.0);
  EXPECT_EQ(command_at({}, 0.0, 1.0).speed, 0.0);
}

TEST(Scenario, MayLeaveEverythingToDefaults) {
  const Scenario scenario = written("{}");
  EXPECT_TRUE(scenario.waypoints.empty());
  EXPECT_TRUE(scenario.sequence.empty());
  EXPECT_TRUE(scenario.localization.IsNull());
  EXPECT_FALSE(scenario.steered_on_truth);
}

TEST(Scenario, RefusesWhatNobodyReads) {
  EXPECT_THROW(written("simulatro: {}"), ParameterError);
  EXPECT_THROW(written("simulator: {robot: {wheelbas: 1}}"), ParameterError);
  EXPECT_THROW(written("steering: {speed: 1}"), ParameterError);
  EXPECT_THROW(written("steering: {waypoints: [[1, 2, 3]]}"), ParameterError);
  EXPECT_THROW(written("steering: {waypoints: [[1, .nan]]}"), ParameterError);
  EXPECT_THROW(written("steering: {waypoints: 5}"), ParameterError);
  EXPECT_THROW(written("sequence: 5"), ParameterError);
  EXPECT_THROW(written("sequence: [{speed: fast}]"), ParameterError);
  EXPECT_THROW(written("sequence: [{velocity: 1}]"), ParameterError);
  EXPECT_THROW(written("duration: -1"), ParameterError);
  EXPECT_THROW(written("duration: long"), ParameterError);
  EXPECT_THROW(written("steered_on: sight"), ParameterError);
  EXPECT_THROW(written("- 1"), ParameterError);
  EXPECT_THROW(written("simulator: &a {robot: *a}"), ParameterError);
  EXPECT_THROW(written("[1, 2]: 3"), ParameterError);
  EXPECT_THROW(load_scenario("/nowhere/at_all.yaml"), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
