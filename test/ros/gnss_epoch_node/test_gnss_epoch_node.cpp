#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "ros/gnss_epoch_node/gnss_epoch_node.hpp"

namespace multipath_localization {
namespace {

TEST(GnssEpochNodeParameters, AreWhatTheFileSays) {
  std::ifstream file(CONFIG_DIR "/drive.yaml");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), describe(GnssEpochNodeParameters{}));
}

TEST(GnssEpochNodeParameters, RefuseByName) {
  GnssEpochNodeParameters parameters;
  const auto refusal_of = [&](const char* yaml) -> std::string {
    try {
      load(YAML::Load(yaml), parameters);
    } catch (const ParameterError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal_of("{drives: /tmp}").find("drives"), std::string::npos);
  EXPECT_NE(refusal_of("{at_end: stop}").find("at_end"), std::string::npos);
  EXPECT_NE(refusal_of("{rate: 0}").find("rate"), std::string::npos);
}

TEST(GnssEpochNodeParameters, DriveTheClockUnlessAtTheRecordedPace) {
  GnssEpochNodeParameters parameters;
  EXPECT_FALSE(parameters.drives_clock());
  parameters.rate = 2.0;
  EXPECT_TRUE(parameters.drives_clock());
  parameters.rate = 1.0;
  parameters.publish_clock = true;
  EXPECT_TRUE(parameters.drives_clock());
}

}  // namespace
}  // namespace multipath_localization
