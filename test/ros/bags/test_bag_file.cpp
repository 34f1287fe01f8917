#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "../../evaluation/temporary_folder.hpp"
#include "recorded_bag.hpp"
#include "ros/bags/bag_file.hpp"
#include "support/csv.hpp"

namespace multipath_localization {
namespace {

std::string bytes_of(const std::string& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

std::string failure_of(const std::string& file) {
  try {
    with_bag(file, [](const rosbag::Bag& bag) {
      for (const rosbag::MessageInstance& message : rosbag::View(bag))
        message.instantiate<nav_msgs::Odometry>();
    });
  } catch (const DriveError& error) {
    return error.what();
  }
  return "";
}

class BagFile : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
};

TEST_F(BagFile, AWholeBagIsReadToItsEnd) { EXPECT_EQ(failure_of(record({})), ""); }

TEST_F(BagFile, WhatIsNoBagIsNamed) {
  EXPECT_EQ(failure_of("/no/such.bag"), "/no/such.bag: there is no such file");
  EXPECT_EQ(failure_of(folder_.path()), folder_.path() + ": a folder, not a bag");
  const std::string empty = folder_.write("empty.bag", "");
  EXPECT_EQ(failure_of(empty), empty + ": an empty file, not a bag");
  const std::string text = folder_.write("text.bag", "hello, this is no bag at all\n");
  EXPECT_EQ(failure_of(text), text + ": not a bag");
}

TEST_F(BagFile, OneThatIsCutOffAsksToBeReindexed) {
  const std::string whole = bytes_of(record({}));
  for (const double share : {0.01, 0.1, 0.5, 0.9, 0.999}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    const std::string cut = folder_.write("cut.bag", whole.substr(0, size));
    EXPECT_EQ(failure_of(cut).find(cut + ": "), 0u);
    EXPECT_NE(failure_of(cut).find("; run rosbag reindex " + cut), std::string::npos)
        << share << failure_of(cut);
  }
}

/// What the recorder writes before it knows where its index will be.
TEST_F(BagFile, OneThatIsStillWrittenAsksToBeReindexed) {
  std::string bytes = bytes_of(record({}));
  const std::size_t place = bytes.find("index_pos=") + std::string("index_pos=").size();
  bytes.replace(place, 8, 8, '\0');
  const std::string active = folder_.write("drive.bag.active", bytes);
  EXPECT_EQ(failure_of(active),
            active + ": no index, as of a recording that was cut off; run rosbag reindex " + active);
}

TEST_F(BagFile, AnotherVersionIsToldByItsSum) {
  rosbag::ConnectionInfo connection;
  connection.datatype = "nav_msgs/Odometry";
  connection.md5sum = ros::message_traits::md5sum<nav_msgs::Odometry>();
  EXPECT_FALSE(of_another_version(connection));
  connection.md5sum = "*";
  EXPECT_TRUE(of_another_version(connection));
  connection.datatype = "some_msgs/NobodyReadsThis";
  EXPECT_FALSE(of_another_version(connection));
}

}  // namespace
}  // namespace multipath_localization
