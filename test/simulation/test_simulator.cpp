#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "multipath_localization/simulation/simulator.hpp"

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
  parameters.zones[0].law = "random_walk";
  return parameters;
}

/// Everything a run gives, number by number.
std::vector<double> run(const SimulatorParameters& parameters, std::uint64_t seed) {
  Simulator simulator(parameters, seed);
  std::vector<double> all;
  for (int i = 0; i < 2000; ++i) {
    const Readings readings = simulator.step({1.0, 0.1});
    all.insert(all.end(),
               {simulator.truth().x, simulator.truth().y, simulator.truth().yaw, simulator.bias().x()});
    if (readings.odometry) all.insert(all.end(), {readings.odometry->speed, readings.odometry->yaw_rate});
    for (const GnssFix& fix : readings.fixes)
      all.insert(all.end(), {fix.stamp, fix.position.x(), fix.position.y()});
  }
  return all;
}

TEST(Simulator, SameSeedSameBytes) {
  EXPECT_EQ(run(noisy(), 7), run(noisy(), 7));
  EXPECT_NE(run(noisy(), 7), run(noisy(), 8));
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
  EXPECT_TRUE(entered.in_shadow());
  EXPECT_NEAR(entered.bias().norm(), 0.5, 1e-9);
  parameters.robot.start_yaw = 0.0;
  EXPECT_FALSE(Simulator(parameters, 1).in_shadow());
}

TEST(Simulator, OfOverlappingZonesTheFirstCounts) {
  SimulatorParameters parameters;
  parameters.zones.resize(2);
  parameters.zones[0].bias_cap = 1.0;
  parameters.robot.start_x = -10.0;
  EXPECT_NEAR(Simulator(parameters, 1).bias().norm(), 1.0, 1e-12);
}

TEST(Simulator, FixesCarryTheBiasOfWhereTheyWereTaken) {
  SimulatorParameters parameters;
  parameters.zones.resize(1);
  parameters.receiver.sigma_shadow = 0.0;
  parameters.robot.start_x = -3.0;
  Simulator simulator(parameters, 1);
  std::vector<GnssFix> fixes;
  while (fixes.empty()) fixes = simulator.step({}).fixes;
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
    for (const GnssFix& fix : readings.fixes) ASSERT_TRUE(fix.position.allFinite());
  }
}

TEST(Simulator, RefusesABuildingWithoutCorners) {
  SimulatorParameters parameters;
  parameters.buildings.resize(1);
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
