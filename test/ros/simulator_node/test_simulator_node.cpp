#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "ros/simulator_node/simulator_node.hpp"

namespace multipath_localization {
namespace {

TEST(SimulatorNode, ConfigFileHoldsTheDefaults) {
  std::stringstream text;
  text << std::ifstream(std::string(CONFIG_DIR) + "/simulator.yaml").rdbuf();
  EXPECT_EQ(text.str(), describe(SimulatorNodeParameters{}));
}

TEST(SimulatorNode, SimulatesTimeOtherThanInRealTime) {
  SimulatorNodeParameters parameters;
  EXPECT_FALSE(parameters.drives_clock());
  parameters.real_time_factor = 4.0;
  EXPECT_TRUE(parameters.drives_clock());
  parameters.real_time_factor = 1.0;
  parameters.publish_clock = true;
  EXPECT_TRUE(parameters.drives_clock());
}

}  // namespace
}  // namespace multipath_localization
