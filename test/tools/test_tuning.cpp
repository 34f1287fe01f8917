#include <gtest/gtest.h>

#include "nodes/localization_parameters.hpp"
#include "tools/tune_from_bag/tuning.hpp"

namespace multipath_localization {
namespace {

SensorNoise told() {
  SensorNoise noise;
  noise.time = 312.0;
  noise.way = 450.0;
  noise.stretches = 7;
  noise.quiet = 5;
  noise.fix = FixNoise{0.4, 0.7, 12.0};
  noise.scale = Measured{0.98, 0.002};
  noise.gyro_bias = Measured{0.003, 0.0004};
  noise.delay = Measured{0.25, 0.02};
  noise.distance_noise = 0.02;
  noise.yaw_noise = 0.004;
  noise.latency = 4.0;
  return noise;
}

/// What the node makes of it. Throws where it refuses a key.
LocalizationSettings settings(const std::string& yaml) {
  return LocalizationSettings::from(YAML::Load(yaml));
}

TEST(Tuning, TheNodeTakesEveryKey) {
  const std::string yaml = tuning(told(), "my_drive");
  const LocalizationSettings node = settings(yaml);
  const YAML::Node filter = node.estimator_parameters;
  EXPECT_NEAR(filter["odometry"]["scale_sigma"].as<double>(), 0.0201, 1e-3);
  EXPECT_NEAR(filter["odometry"]["gyro_bias_sigma"].as<double>(), 0.003, 1e-4);
  EXPECT_NEAR(filter["odometry"]["distance"].as<double>(), 0.02, 1e-4);
  EXPECT_NEAR(filter["odometry"]["yaw"].as<double>(), 0.004, 1e-4);
  EXPECT_NEAR(filter["classes"]["street"]["quiet_sigma"].as<double>(), 0.4, 1e-3);
  EXPECT_NEAR(filter["classes"]["street"]["open_bias_sigma"].as<double>(), 0.7, 1e-3);
  EXPECT_NEAR(filter["classes"]["street"]["open_bias_time"].as<double>(), 12.0, 0.1);
  EXPECT_NEAR(node.parameters.gnss.fix.default_sigma, 0.806, 0.01);
  EXPECT_NEAR(node.parameters.localizer.history_length, 8.0, 0.1);
}

TEST(Tuning, SaysFromWhatItIs) {
  const std::string yaml = tuning(told(), "my_drive");
  EXPECT_NE(yaml.find("my_drive: from 312 s and 450 m of driving in 5 of 7 stretches"), std::string::npos)
      << yaml;
  EXPECT_NE(yaml.find("0.25 +- 0.02 s before its stamp"), std::string::npos) << yaml;
}

TEST(Tuning, WhatIsNotToldHasNoValue) {
  SensorNoise noise = told();
  noise.distance_noise.reset();
  noise.yaw_noise.reset();
  noise.delay.reset();
  noise.fix = FixNoise{0.4, 0.7, std::nullopt};
  const std::string yaml = tuning(noise, "my_drive");
  const YAML::Node filter = settings(yaml).estimator_parameters;
  EXPECT_FALSE(filter["odometry"]["distance"]);
  EXPECT_FALSE(filter["odometry"]["yaw"]);
  EXPECT_FALSE(filter["classes"]["street"]["open_bias_time"]);
  for (const char* what :
       {"# distance: not told", "# yaw: not told", "# open_bias_time: not told", "# delay: not told"}) {
    EXPECT_NE(yaml.find(what), std::string::npos) << yaml;
  }
}

TEST(Tuning, StaysInTheRangesOfTheNode) {
  SensorNoise noise = told();
  noise.scale = Measured{3.0, 0.1};
  noise.gyro_bias = Measured{1.0, 0.1};
  noise.distance_noise = 7.0;
  noise.fix = FixNoise{0.0, 0.0, std::nullopt};
  EXPECT_NO_THROW(settings(tuning(noise, "my_drive")));
}

TEST(Tuning, OfNothingIsACommentAlone) {
  const std::string yaml = tuning(SensorNoise{}, "my_drive");
  EXPECT_TRUE(YAML::Load(yaml).IsNull());
  EXPECT_NE(yaml.find("Too little"), std::string::npos);
}

/// Values of a file, those of nested maps too.
std::size_t leaves(const YAML::Node& node) {
  if (!node.IsMap()) return 1;
  std::size_t sum = 0;
  for (const auto& entry : node) sum += leaves(entry.second);
  return sum;
}

TEST(RobotFile, HoldsEightNumbersAndTheyAreTheDefaults) {
  const YAML::Node file = read_yaml(std::string(CONFIG_DIR) + "/robot.yaml");
  EXPECT_EQ(leaves(file), 8U);
  const LocalizationSettings robot = LocalizationSettings::from(file);
  EXPECT_EQ(describe(robot.parameters), describe(LocalizationParameters{}));
  const YAML::Node filter = read_yaml(std::string(CONFIG_DIR) + "/multipath_particle_filter.yaml");
  for (const auto& entry : robot.estimator_parameters["odometry"]) {
    const auto key = entry.first.as<std::string>();
    EXPECT_EQ(entry.second.as<double>(), filter["odometry"][key].as<double>()) << key;
  }
}

}  // namespace
}  // namespace multipath_localization
