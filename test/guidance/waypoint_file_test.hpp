#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/guidance/waypoint_file.hpp"

namespace multipath_localization {

/// Files of waypoints in a folder of the test's own.
class WaypointFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string holding(const std::string& name, const std::string& content) const {
    const std::filesystem::path file = folder_ / name;
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }

  std::vector<Eigen::Vector2d> places(const std::string& name, const std::string& content) const {
    const WaypointList list = read_waypoints(holding(name, content)).value();
    EXPECT_TRUE(list.on_earth);
    return list.points;
  }

  /// What a file is refused for, after its name; empty when it is not refused.
  std::string refusal(const std::string& name, const std::string& content) const {
    const std::string file = holding(name, content);
    try {
      read_waypoints(file);
    } catch (const ParameterError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.rfind(file, 0), 0U) << text;
      return text.substr(file.size());
    }
    return "";
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      testing::UnitTest::GetInstance()->current_test_info()->test_suite_name();
};

}  // namespace multipath_localization
