#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "simulation/faults.hpp"
#include "simulation/simulator.hpp"

namespace multipath_localization {
namespace {

SimulatorParameters noisy() {
  SimulatorParameters parameters;
  parameters.robot.noise_scale = 1e-3;
  parameters.odometer.yaw_rate_noise = 0.02;
  parameters.odometer.gyro_bias_sigma = 0.01;
  parameters.receiver.coloured_sigma = 0.5;
  parameters.receiver.latency = 0.1;
  parameters.receiver.latency_jitter = 0.1;
  parameters.zones.resize(1);
  parameters.zones[0].law = ZoneLaw::kRandomWalk;
  return parameters;
}

std::vector<GnssFix> fixes_of(const Readings& readings) {
  std::vector<GnssFix> fixes;
  for (const Measurement& measurement : readings.measurements) {
    if (const auto* fix = std::get_if<GnssFix>(&measurement)) fixes.push_back(*fix);
  }
  return fixes;
}

/// Everything a run gives, number by number.
std::vector<double> run(const SimulatorParameters& parameters, std::uint64_t seed) {
  Simulator simulator(parameters, seed);
  std::vector<double> all;
  for (int i = 0; i < 2000; ++i) {
    const Readings readings = simulator.step({1.0, 0.1});
    all.insert(all.end(), {simulator.truth().x, simulator.truth().y, simulator.truth().yaw,
                           simulator.around().bias.x()});
    if (readings.odometry) all.insert(all.end(), {readings.odometry->speed, readings.odometry->yaw_rate});
    for (const GnssFix& fix : fixes_of(readings))
      all.insert(all.end(), {fix.stamp, fix.position.x(), fix.position.y()});
  }
  return all;
}

TEST(Simulator, SameSeedSameBytes) {
  EXPECT_EQ(run(noisy(), 7), run(noisy(), 7));
  EXPECT_NE(run(noisy(), 7), run(noisy(), 8));
}

TEST(Simulator, APairOfAntennasDisturbsNothingElse) {
  SimulatorParameters parameters = noisy();
  parameters.dual_receiver.rate = 10.0;
  EXPECT_EQ(run(parameters, 7), run(noisy(), 7));
}

TEST(Simulator, FaultsSpoilFixesAndOdometry) {
  SimulatorParameters parameters;
  parameters.faults.fix.outages.push_back({2.0, 3.0});
  parameters.faults.fix.statuses.emplace_back();
  parameters.faults.odometry.slips = {{2.0, 3.0, -1.0}};
  Simulator simulator(parameters, 1);
  for (int i = 0; i < 1000; ++i) {
    const Readings readings = simulator.step({1.0, 0.0});
    const bool there = simulator.time() > 1.99 && simulator.time() < 4.99;
    if (there) {
      EXPECT_TRUE(fixes_of(readings).empty());
    }
    if (readings.odometry && simulator.time() > 1.0) {
      EXPECT_EQ(readings.odometry->speed == 0.0, there) << simulator.time();
    }
  }
  EXPECT_EQ(simulator.claimed_status(1.0), -1);
  EXPECT_FALSE(Simulator(SimulatorParameters{}, 1).claimed_status(1.0));
}

TEST(Simulator, PairsOfFixesTellThePose) {
  SimulatorParameters parameters;
  parameters.dual_receiver.rate = 5.0;
  parameters.receiver.rate = 0.0;
  parameters.robot.start_yaw = 2.0;
  Simulator simulator(parameters, 1);
  int pairs = 0;
  for (int i = 0; i < 1000; ++i) {
    for (const Measurement& measurement : simulator.step({1.0, 0.1}).measurements) {
      const auto* fixes = std::get_if<DualAntennaFix>(&measurement);
      ASSERT_NE(fixes, nullptr);
      const Eigen::Vector3d told = dual_antenna_pose(*fixes, 0.0)->pose;
      EXPECT_LT((told.head<2>() - simulator.truth().position()).norm(), 0.1);
      EXPECT_LT(std::abs(angle_difference(told.z(), simulator.truth().yaw)), 0.12);
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 50);
}

TEST(Simulator, TimeIsCountedInStepsWithoutDrift) {
  SimulatorParameters parameters;
  parameters.time_step = 0.1;
  Simulator simulator(parameters, 1);
  EXPECT_EQ(simulator.time(), 0.0);
  for (int i = 0; i < 36000; ++i) simulator.step({});
  EXPECT_DOUBLE_EQ(simulator.time(), 3600.0);
}

TEST(Simulator, ShadowBeginsWhereTheAntennaEntersIt) {
  SimulatorParameters parameters;
  parameters.zones.resize(1);  // x < 0
  parameters.receiver.antenna_x = 1.0;
  parameters.robot.start_x = 0.5;
  parameters.robot.start_yaw = 3.14159265358979;
  const Simulator entered(parameters, 1);
  EXPECT_TRUE(entered.around().in_shadow);
  EXPECT_NEAR(entered.around().bias.norm(), 0.5, 1e-9);
  parameters.robot.start_yaw = 0.0;
  EXPECT_FALSE(Simulator(parameters, 1).around().in_shadow);
}

TEST(Simulator, OfOverlappingZonesTheFirstCounts) {
  SimulatorParameters parameters;
  parameters.zones.resize(2);
  parameters.zones[0].bias_cap = 1.0;
  parameters.robot.start_x = -10.0;
  EXPECT_NEAR(Simulator(parameters, 1).around().bias.norm(), 1.0, 1e-12);
}

TEST(Simulator, FixesCarryTheBiasOfWhereTheyWereTaken) {
  SimulatorParameters parameters;
  parameters.zones.resize(1);
  parameters.receiver.sigma_shadow = 0.0;
  parameters.robot.start_x = -3.0;
  Simulator simulator(parameters, 1);
  std::vector<GnssFix> fixes;
  while (fixes.empty()) fixes = fixes_of(simulator.step({}));
  EXPECT_NEAR((fixes[0].position - Eigen::Vector2d(-6.0, 0.0)).norm(), 0.0, 1e-9);
}

TEST(Simulator, StaysFiniteWhateverTheCommand) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> hostile = {
      std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e308, -1e308, 0};
  Simulator simulator(noisy(), 1);
  for (int i = 0; i < 360; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const Readings readings = simulator.step({hostile[n % 6], hostile[n / 6 % 6]});
    ASSERT_TRUE(simulator.truth().finite());
    if (readings.odometry) {
      ASSERT_TRUE(std::isfinite(readings.odometry->speed) && std::isfinite(readings.odometry->yaw_rate));
    }
    for (const GnssFix& fix : fixes_of(readings)) ASSERT_TRUE(fix.position.allFinite());
  }
}

/// A street between two houses.
SimulatorParameters among_satellites() {
  SimulatorParameters parameters = noisy();
  parameters.receiver.source = ReceiverSource::kSatellites;
  parameters.buildings = {{"north", {-100, 10, 100, 10, 100, 30, -100, 30}, 40.0},
                          {"south", {-100, -30, 100, -30, 100, -10, -100, -10}, 30.0}};
  return parameters;
}

TEST(Simulator, BySatellitesItHandsOutPseudorangesAndFixes) {
  SimulatorParameters parameters = among_satellites();
  parameters.receiver.latency = parameters.receiver.latency_jitter = 0.0;
  parameters.outages = {{4.0, 2.0}};
  Simulator simulator(parameters, 1);
  int epochs = 0;
  int fixes = 0;
  for (int i = 0; i < 1000; ++i) {
    for (const Measurement& measurement : simulator.step({1.0, 0.0}).measurements) {
      EXPECT_EQ(stamp_of(measurement), simulator.time());
      EXPECT_FALSE(simulator.time() > 3.99 && simulator.time() < 5.99);
      epochs += std::holds_alternative<PseudorangeEpoch>(measurement) ? 1 : 0;
      const auto* fix = std::get_if<GnssFix>(&measurement);
      if (fix == nullptr) continue;
      ++fixes;
      EXPECT_LT((fix->position - simulator.truth().position() - simulator.around().bias).norm(), 1e-9);
    }
  }
  EXPECT_EQ(epochs, 40);
  EXPECT_EQ(fixes, 40);
}

TEST(Simulator, BySatellitesSameSeedSameBytes) {
  EXPECT_EQ(run(among_satellites(), 7), run(among_satellites(), 7));
  EXPECT_NE(run(among_satellites(), 7), run(among_satellites(), 8));
}

TEST(Simulator, ByZonesSatellitesAndBuildingsChangeNothing) {
  SimulatorParameters parameters = noisy();
  const std::vector<double> before = run(parameters, 7);
  parameters.buildings = among_satellites().buildings;
  parameters.constellations.epoch_spread = 1e5;
  parameters.sky.reflection_loss_db = 20.0;
  parameters.raw_receiver.code_noise = 9.0;
  parameters.receiver.antenna_z = 5.0;
  EXPECT_EQ(run(parameters, 7), before);
}

TEST(Simulator, RefusesABuildingWithoutCorners) {
  SimulatorParameters parameters;
  parameters.buildings.resize(1);
  EXPECT_THROW(Simulator(parameters, 1), ParameterError);
  parameters.receiver.source = ReceiverSource::kSatellites;
  EXPECT_THROW(Simulator(parameters, 1), ParameterError);
}

TEST(SimulatorParameters, DescribeThemselvesAndLoadBack) {
  SimulatorParameters parameters = noisy();
  parameters.outages = {{5.0, 10.0}};
  const std::string text = describe(parameters);
  SimulatorParameters loaded;
  load(YAML::Load(text), loaded);
  EXPECT_EQ(describe(loaded), text);
}

}  // namespace
}  // namespace multipath_localization
