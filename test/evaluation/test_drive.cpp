#include <gtest/gtest.h>

#include "multipath_localization/evaluation/drive.hpp"
#include "temporary_folder.hpp"

namespace multipath_localization {
namespace {

constexpr char kOdometry[] = "wz,t,vx\n0.1,0,1\n0.3,0.5,3\n0,1,2\n";
constexpr char kFixes[] =
    "t,lat_deg,lon_deg,alt_m,cov_ee_m2,cov_en_m2,cov_nn_m2\n"
    "0,50,10,100,4,1,9\n"
    "1,50.001,10,100,1,0,1\n";
constexpr char kTruth[] = "t,lon_deg,lat_deg\n0,10,50\n1,10.001,50\n";

class ReadDrive : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("odometry.csv", kOdometry);
    folder_.write("fix.csv", kFixes);
    folder_.write("truth.csv", kTruth);
  }

  [[nodiscard]] std::string failure() const {
    try {
      read_drive(folder_.path());
    } catch (const DriveError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(ReadDrive, TakesTheFirstFixAsDatum) {
  const Drive drive = read_drive(folder_.path() + "/");
  EXPECT_EQ(drive.name, std::filesystem::path(folder_.path()).filename());
  ASSERT_EQ(drive.fixes.size(), 2u);
  EXPECT_NEAR(drive.fixes[0].fix.position.norm(), 0.0, 1e-9);
  EXPECT_NEAR(drive.fixes[1].fix.position.x(), 0.0, 1e-6);
  EXPECT_NEAR(drive.fixes[1].fix.position.y(), 111.23, 0.02);
  EXPECT_DOUBLE_EQ(drive.fixes[0].fix.covariance(0, 0), 4.0);
  EXPECT_DOUBLE_EQ(drive.fixes[0].fix.covariance(1, 0), 1.0);
  EXPECT_DOUBLE_EQ(drive.fixes[0].fix.covariance(1, 1), 9.0);
  ASSERT_EQ(drive.truth.size(), 2u);
  EXPECT_NEAR(drive.truth[1].base_in_map.x, 71.69, 0.02);
  EXPECT_FALSE(drive.truth[0].has_yaw);
  EXPECT_FALSE(drive.truth[0].shadow);
}

TEST_F(ReadDrive, OdometryBecomesIncrementsOfMeanTwist) {
  const Drive drive = read_drive(folder_.path());
  ASSERT_EQ(drive.odometry.size(), 3u);
  EXPECT_DOUBLE_EQ(drive.odometry[0].duration, 1e-3);
  EXPECT_DOUBLE_EQ(drive.odometry[1].stamp, 0.5);
  EXPECT_DOUBLE_EQ(drive.odometry[1].duration, 0.5);
  EXPECT_DOUBLE_EQ(drive.odometry[1].speed, 2.0);
  EXPECT_DOUBLE_EQ(drive.odometry[1].yaw_rate, 0.2);
}

TEST_F(ReadDrive, HeadingAndShadowCountWhereTheyAreGiven) {
  folder_.write("truth.csv", "t,lat_deg,lon_deg,yaw,shadow\n0,50,10,0.5,0\n1,50,10,0.7,1\n");
  const Drive drive = read_drive(folder_.path());
  EXPECT_TRUE(drive.truth[0].has_yaw);
  EXPECT_DOUBLE_EQ(drive.truth[1].base_in_map.yaw, 0.7);
  EXPECT_EQ(drive.truth[0].shadow, std::optional<bool>(false));
  EXPECT_EQ(drive.truth[1].shadow, std::optional<bool>(true));
}

TEST_F(ReadDrive, FixesGoByArrival) {
  folder_.write("fix.csv",
                "t,lat_deg,lon_deg,cov_ee_m2,cov_en_m2,cov_nn_m2,t_arrival\n"
                "0,50,10,1,0,1,0.9\n0.2,50,10,1,0,1,0.3\n");
  const Drive drive = read_drive(folder_.path());
  EXPECT_DOUBLE_EQ(drive.fixes[0].fix.stamp, 0.2);
  EXPECT_DOUBLE_EQ(drive.fixes[1].fix.stamp, 0.0);
  EXPECT_DOUBLE_EQ(drive.fixes[1].arrival, 0.9);
}

TEST_F(ReadDrive, RefusesWithFileLineAndReason) {
  folder_.write("odometry.csv", "t,vx,wz\n0,1,0\n0,1,0\n");
  EXPECT_EQ(failure(), folder_.path() + "/odometry.csv:3: t does not increase");
  folder_.write("odometry.csv", "t,vx\n0,1\n1,1\n");
  EXPECT_EQ(failure(), folder_.path() + "/odometry.csv:1: no column wz");
  folder_.write("odometry.csv", kOdometry);
  folder_.write("truth.csv", "t,lat_deg,lon_deg\n0,91,10\n");
  EXPECT_EQ(failure(), folder_.path() + "/truth.csv:2: latitude or longitude out of range");
  folder_.write("truth.csv", kTruth);
  std::filesystem::remove(folder_.path() + "/fix.csv");
  EXPECT_EQ(failure(), folder_.path() + "/fix.csv: cannot be read or is empty");
}

TEST(TruthAt, IsLinearAndTurnsTheShortWay) {
  const std::vector<TruthSample> truth = {{0.0, {0.0, 0.0, 3.0}, true, true},
                                          {2.0, {4.0, 2.0, -3.0}, true, false}};
  const std::optional<TruthSample> half = truth_at(truth, 1.0);
  ASSERT_TRUE(half);
  EXPECT_DOUBLE_EQ(half->base_in_map.x, 2.0);
  EXPECT_DOUBLE_EQ(half->base_in_map.y, 1.0);
  EXPECT_NEAR(half->base_in_map.yaw, kPi, 1e-12);
  EXPECT_EQ(half->shadow, std::optional<bool>(true));
  EXPECT_EQ(truth_at(truth, 2.0)->shadow, std::optional<bool>(false));
  EXPECT_FALSE(truth_at(truth, 2.1));
  EXPECT_FALSE(truth_at(truth, -0.1));
}

}  // namespace
}  // namespace multipath_localization
