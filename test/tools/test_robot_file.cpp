#include <gtest/gtest.h>

#include "ros/localization_node/localization_parameters.hpp"

namespace multipath_localization {
namespace {

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
