#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "ros/gnss_receiver_node/gnss_receiver_node.hpp"

namespace multipath_localization {
namespace {

TEST(GnssReceiverParameters, AreDescribedByTheirYaml) {
  std::stringstream text;
  text << std::ifstream(CONFIG_DIR "/gnss_receiver.yaml").rdbuf();
  EXPECT_EQ(text.str(), describe(GnssReceiverParameters()));
}

TEST(GnssReceiverParameters, FilesAreAbsolutePaths) {
  for (const char* key : {"ephemeris_file", "navigation_file", "record_file"}) {
    GnssReceiverParameters parameters;
    EXPECT_NO_THROW(load(YAML::Load(std::string(key) + ": /tmp/file"), parameters));
    EXPECT_THROW(load(YAML::Load(std::string(key) + ": file"), parameters), ParameterError);
  }
}

TEST(UtcStamp, IsTheTimeOfGpsLessLeapSeconds) {
  // 17 May 2021, 02:33:13.005 GPS time.
  const ros::Time stamp = utc_stamp({2158, 95593.005}, 18);
  EXPECT_EQ(stamp.sec, 1621218775U);
  EXPECT_NEAR(stamp.nsec, 5e6, 10.0);
}

}  // namespace
}  // namespace multipath_localization
