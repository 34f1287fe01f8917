#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "evaluation/drive_files.hpp"
#include "evaluation/random_drive.hpp"
#include "temporary_folder.hpp"

namespace multipath_localization {
namespace {

TEST(DriveFiles, GiveTheDriveBackThatWasWritten) {
  const TemporaryFolder folder;
  const Drive written = random_drive(7).drive;
  write_drive(written, folder.path() + "/seven");
  const Drive read = read_drive(folder.path() + "/seven");
  ASSERT_EQ(read.odometry.size(), written.odometry.size());
  for (std::size_t i = 0; i < read.odometry.size(); ++i) {
    ASSERT_EQ(read.odometry[i].stamp, written.odometry[i].stamp);
    ASSERT_EQ(read.odometry[i].duration, written.odometry[i].duration);
    ASSERT_EQ(read.odometry[i].speed, written.odometry[i].speed);
    ASSERT_EQ(read.odometry[i].yaw_rate, written.odometry[i].yaw_rate);
  }
  const std::vector<GnssFix> fixes = read.fixes();
  const std::vector<GnssFix> before = written.fixes();
  ASSERT_EQ(fixes.size(), before.size());
  ASSERT_EQ(read.truth.size(), written.truth.size());
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    ASSERT_EQ(fixes[i].status, before[i].status);
    ASSERT_EQ(fixes[i].covariance, before[i].covariance);
    const Eigen::Vector2d error =
        fixes[i].position - truth_at(read.truth, fixes[i].stamp)->base_in_map.position();
    const Eigen::Vector2d expected =
        before[i].position - truth_at(written.truth, fixes[i].stamp)->base_in_map.position();
    ASSERT_NEAR((error - expected).norm(), 0.0, 0.01);  // another datum turns the map's north
  }
  EXPECT_EQ(read.truth.back().shadow, written.truth.back().shadow);
}

/// The last one of its kind.
template <class Kind>
Kind last(const Drive& drive) {
  Kind found;
  for (const RecordedMeasurement& recorded : drive.measurements) {
    if (const auto* one = std::get_if<Kind>(&recorded.measurement)) found = *one;
  }
  return found;
}

TEST(DriveFiles, GiveYawRatesVelocitiesAndHeadingsBack) {
  const TemporaryFolder folder;
  Drive written = random_drive(7, {true, true, false, true}).drive;
  for (RecordedYawRate& recorded : written.yaw_rates) recorded.arrival += 0.1;
  write_drive(written, folder.path() + "/seven");
  const Drive read = read_drive(folder.path() + "/seven");
  ASSERT_EQ(read.yaw_rates.size(), written.yaw_rates.size());
  ASSERT_EQ(read.measurements.size(), written.measurements.size());
  for (std::size_t i = 0; i < read.yaw_rates.size(); ++i) {
    ASSERT_EQ(read.yaw_rates[i].yaw_rate.stamp, written.yaw_rates[i].yaw_rate.stamp);
    ASSERT_EQ(read.yaw_rates[i].yaw_rate.rate, written.yaw_rates[i].yaw_rate.rate);
    ASSERT_EQ(read.yaw_rates[i].arrival, written.yaw_rates[i].arrival);
  }
  const auto velocity = last<GnssVelocity>(read), velocity_written = last<GnssVelocity>(written);
  EXPECT_GT(velocity.stamp, 0.0);
  EXPECT_EQ(velocity.velocity, velocity_written.velocity);
  EXPECT_NEAR((velocity.covariance - velocity_written.covariance).norm(), 0.0, 1e-12);
  const auto heading = last<Heading>(read), heading_written = last<Heading>(written);
  EXPECT_GT(heading.stamp, 0.0);
  EXPECT_NEAR(heading.yaw, heading_written.yaw, 1e-12);
  EXPECT_NEAR(heading.variance, heading_written.variance, 1e-12);
}

TEST(DriveFiles, GiveTheLevelsOfFixesBack) {
  const TemporaryFolder folder;
  Drive written = random_drive(7).drive;
  for (RecordedMeasurement& recorded : written.measurements) {
    std::get<GnssFix>(recorded.measurement).level = FixLevel::kFloat;
  }
  write_drive(written, folder.path() + "/seven");
  for (const GnssFix& fix : read_drive(folder.path() + "/seven").fixes()) {
    ASSERT_EQ(fix.level, FixLevel::kFloat);
  }
}

TEST(DriveFiles, GiveTheFixesOfFurtherReceiversBack) {
  const TemporaryFolder folder;
  const Drive written = random_drive(7, {false, false, true}).drive;
  write_drive(written, folder.path() + "/seven");
  const Drive read = read_drive(folder.path() + "/seven");
  ASSERT_EQ(read.receivers(), 2u);
  ASSERT_EQ(read.fixes(1).size(), written.fixes(1).size());
  EXPECT_EQ(read.fixes(1).back().stamp, written.fixes(1).back().stamp);
  EXPECT_EQ(read.fixes(1).back().covariance, written.fixes(1).back().covariance);
  EXPECT_EQ(read.fixes(1).back().antenna_in_base, Eigen::Vector2d(0.0, -0.8));
  EXPECT_EQ(read.fixes().back().antenna_in_base, Eigen::Vector2d::Zero());
}

TEST(DriveFiles, FindsDrivesAndSaysWhatIsNone) {
  const TemporaryFolder folder;
  const Drive drive = random_drive(7).drive;
  write_drive(drive, folder.path() + "/a");
  write_drive(drive, folder.path() + "/b");
  std::filesystem::remove(folder.path() + "/b/odometry.csv");
  std::filesystem::create_directory(folder.path() + "/c");
  write_drive(drive, folder.path() + "/d");
  std::ofstream(folder.path() + "/d/odometry.csv", std::ios::app) << "0,0,0,0,1\n";
  const FoundDrives found = read_drives(folder.path(), 60.0);
  ASSERT_EQ(found.drives.size(), 1u);
  EXPECT_EQ(found.drives.front().name, "a");
  ASSERT_EQ(found.left_out.size(), 3u);
  EXPECT_EQ(found.left_out[0], "b: no odometry.csv");
  EXPECT_EQ(found.left_out[1], "c: no truth.csv");
  EXPECT_NE(found.left_out[2].find("t does not increase"), std::string::npos) << found.left_out[2];
  EXPECT_THROW(read_drives(folder.path(), 1e4), DriveError);  // all too short
  EXPECT_THROW(read_drives(folder.path() + "/nowhere", 0.0), DriveError);
}

}  // namespace
}  // namespace multipath_localization
