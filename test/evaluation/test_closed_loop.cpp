#include <gtest/gtest.h>

#include "dead_reckoning.hpp"
#include "evaluation/closed_loop.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"

namespace multipath_localization {
namespace {

/// The shipped street without any error of robot and odometer, so that dead reckoning from a known start is
/// exact.
Scenario perfect_street() {
  Scenario scenario = load_scenario(std::string(CONFIG_DIR) + "/scenarios/street.yaml");
  scenario.simulator.robot.noise_scale = 0.0;
  scenario.simulator.odometer = {};
  scenario.simulator.odometer.rate = 50.0;
  scenario.simulator.odometer.speed_scale_error = scenario.simulator.odometer.gyro_bias = 0.0;
  scenario.simulator.odometer.speed_scale_error_sigma = scenario.simulator.odometer.gyro_bias_sigma = 0.0;
  scenario.simulator.odometer.speed_noise = scenario.simulator.odometer.speed_noise_ratio = 0.0;
  scenario.simulator.odometer.yaw_rate_noise = scenario.simulator.odometer.slip_rate = 0.0;
  return scenario;
}

RunSettings known() {
  RunSettings settings;
  settings.known_start = true;
  return settings;
}

std::unique_ptr<Estimator> dead_reckoning() { return std::make_unique<DeadReckoning>(); }

TEST(RunScenario, WithAPerfectOdometerTheRobotGetsRound) {
  Scenario scenario = perfect_street();
  scenario.duration = 150.0;
  const ClosedLoopRun run = run_scenario(scenario, 1, dead_reckoning, known());
  const Score s = score(run.epochs, 0.0);
  EXPECT_EQ(run.epochs.size(), static_cast<std::size_t>(150.0 / scenario.simulator.time_step));
  EXPECT_LT(*s.max, 0.05);
  EXPECT_LT(*s.heading_rmse, 0.01);
  EXPECT_GE(run.course.waypoints_passed, scenario.waypoints.size());
  EXPECT_GE(run.course.laps, 1);
  ASSERT_TRUE(run.course.worst_miss);
  EXPECT_LT(*run.course.worst_miss, scenario.steering.switch_radius + 0.05);
}

TEST(RunScenario, KnowsTheShadowAndTheFixesInIt) {
  Scenario scenario = perfect_street();
  scenario.duration = 60.0;
  const ClosedLoopRun run = run_scenario(scenario, 1, dead_reckoning, known());
  const Score fixes = score_fixes(run.drive, 0.0);
  ASSERT_TRUE(fixes.rmse_shadow && fixes.rmse_open);
  EXPECT_GT(*fixes.rmse_shadow, 2.0 * *fixes.rmse_open);
}

/// An estimator that is lost would be at a loss for the way; a driver is not.
TEST(RunScenario, SteeredOnTheTruthTheRobotGetsRoundWhateverTheEstimate) {
  Scenario scenario = load_scenario(std::string(CONFIG_DIR) + "/scenarios/street.yaml");
  scenario.simulator.odometer.speed_scale_error = 0.5;
  scenario.steered_on_truth = true;
  scenario.duration = 150.0;
  const ClosedLoopRun run = run_scenario(scenario, 1, dead_reckoning, known());
  EXPECT_GT(*score(run.epochs, 0.0).max, 20.0);
  EXPECT_GE(run.course.laps, 1);
  EXPECT_LT(*run.course.worst_miss, scenario.steering.switch_radius + 0.05);
}

TEST(RunScenario, ReplayingItsDriveGivesTheSameEpochs) {
  Scenario scenario = load_scenario(std::string(CONFIG_DIR) + "/scenarios/street.yaml");
  scenario.duration = 20.0;
  const auto make = [] { return make_estimator(estimator_names().front(), YAML::Node(), 1); };
  const ClosedLoopRun run = run_scenario(scenario, 1, make, {});
  const std::vector<Epoch> replayed = run_drive(run.drive, make, {});
  ASSERT_EQ(replayed.size(), run.epochs.size());
  for (std::size_t i = 0; i < replayed.size(); ++i) {
    ASSERT_EQ(replayed[i].valid, run.epochs[i].valid) << i;
    ASSERT_EQ(replayed[i].estimate.x, run.epochs[i].estimate.x) << i;
    ASSERT_EQ(replayed[i].estimate.yaw, run.epochs[i].estimate.yaw) << i;
  }
}

TEST(RunScenario, DrivesASequenceWhateverTheEstimate) {
  Scenario scenario = perfect_street();
  scenario.sequence = {{5.0, 0.0, 0.0}, {10.0, 1.0, 0.1}};
  scenario.duration = 20.0;
  scenario.simulator.robot.max_acceleration = scenario.simulator.robot.max_steering_rate = 1e6;
  const ClosedLoopRun run = run_scenario(scenario, 1, dead_reckoning, {});
  const auto travelled = [&](double from, double to) {
    const Pose2 start = truth_at(run.drive.truth, from)->base_in_map;
    return inverse(start) * truth_at(run.drive.truth, to)->base_in_map;
  };
  EXPECT_EQ(travelled(0.02, 5.0).position().norm(), 0.0);
  EXPECT_NEAR(travelled(5.0, 15.0).yaw, 1.0, 1e-6);
  EXPECT_NEAR(travelled(5.0, 15.0).position().norm(), 20.0 * std::sin(0.5), 1e-6);
  EXPECT_EQ(travelled(15.0, 20.0).position().norm(), 0.0);
}

TEST(RunScenario, StandsWhileNothingIsKnown) {
  Scenario scenario = perfect_street();
  scenario.duration = 5.0;
  scenario.simulator.outages.emplace_back();
  scenario.simulator.outages.back().start = 0.0;
  scenario.simulator.outages.back().duration = 10.0;
  const ClosedLoopRun run = run_scenario(scenario, 1, dead_reckoning, {});
  EXPECT_NEAR(run.course.standing, 5.0, 1e-6);
  EXPECT_EQ(run.course.waypoints_passed, 0u);
  EXPECT_FALSE(run.course.worst_miss);
  EXPECT_EQ(score(run.epochs, 0.0).epochs, 0u);
}

}  // namespace
}  // namespace multipath_localization
