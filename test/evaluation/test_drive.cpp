#include <gtest/gtest.h>

#include <sstream>

#include "../models/sky.hpp"
#include "evaluation/drive.hpp"
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
  ASSERT_EQ(drive.fixes().size(), 2u);
  EXPECT_NEAR(drive.fixes()[0].position.norm(), 0.0, 1e-9);
  EXPECT_NEAR(drive.fixes()[1].position.x(), 0.0, 1e-6);
  EXPECT_NEAR(drive.fixes()[1].position.y(), 111.23, 0.02);
  EXPECT_DOUBLE_EQ(drive.fixes()[0].covariance(0, 0), 4.0);
  EXPECT_DOUBLE_EQ(drive.fixes()[0].covariance(1, 0), 1.0);
  EXPECT_DOUBLE_EQ(drive.fixes()[0].covariance(1, 1), 9.0);
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

TEST_F(ReadDrive, ReadsMotionSidewaysWhereItIsGiven) {
  EXPECT_EQ(read_drive(folder_.path()).odometry[1].lateral_speed, 0.0);
  folder_.write("odometry.csv", "t,vx,wz,vy\n0,1,0.1,0.2\n0.5,3,0.3,-0.6\n");
  EXPECT_DOUBLE_EQ(read_drive(folder_.path()).odometry[1].lateral_speed, -0.2);
}

TEST_F(ReadDrive, TwistsWithADurationAreMeansOverIt) {
  folder_.write("odometry.csv", "t,vx,wz,duration\n0.5,1,0.1,0.5\n1,3,0.3,0.25\n");
  const Drive drive = read_drive(folder_.path());
  ASSERT_EQ(drive.odometry.size(), 2u);
  EXPECT_EQ(drive.odometry[0].speed, 1.0);
  EXPECT_EQ(drive.odometry[0].duration, 0.5);
  EXPECT_EQ(drive.odometry[1].yaw_rate, 0.3);
  EXPECT_EQ(drive.odometry[1].duration, 0.25);
  folder_.write("odometry.csv", "t,vx,wz,duration\n0.5,1,0.1,0.5\n1,3,0.3,0\n");
  EXPECT_EQ(failure(), folder_.path() + "/odometry.csv:3: duration is not above 0");
}

TEST_F(ReadDrive, FixesClaimTheirStatusAndThoseThatAreNoneAreRefused) {
  const std::string header = "t,lat_deg,lon_deg,cov_ee_m2,cov_en_m2,cov_nn_m2,status\n";
  folder_.write("fix.csv", header + "0,,,,,,-1\n1,50,10,1,0,1,2\n2,50,10,1,0,1,1\n3,50,10,1,0,1,0\n");
  const Drive drive = read_drive(folder_.path());
  ASSERT_EQ(drive.fixes().size(), 3u);
  EXPECT_EQ(drive.fixes()[0].status, FixStatus::kGroundBased);
  EXPECT_EQ(drive.fixes()[1].status, FixStatus::kSatelliteBased);
  EXPECT_EQ(drive.fixes()[2].status, FixStatus::kSingle);
  EXPECT_EQ(drive.notices, (std::vector<std::string>{"fix.csv: 1 rows refused: no fix"}));
  folder_.write("fix.csv", header + "0,50,10,1,0,1,-1\n");
  EXPECT_EQ(failure(), folder_.path() + "/fix.csv: no fix");
  folder_.write("fix.csv", header + "0,50,10,1,0,1,3\n");
  EXPECT_EQ(failure(), folder_.path() + "/fix.csv:2: status is none of -1, 0, 1, 2");
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
  EXPECT_DOUBLE_EQ(drive.fixes()[0].stamp, 0.2);
  EXPECT_DOUBLE_EQ(drive.fixes()[1].stamp, 0.0);
  EXPECT_DOUBLE_EQ(drive.measurements[1].arrival, 0.9);
}

TEST_F(ReadDrive, EpochsOfPseudorangesGoWithTheFixesByArrival) {
  folder_.write("pseudoranges.csv",
                "t,sat_id,system,elevation_deg,cn0_dbhz,sat_x,sat_y,sat_z,pseudorange_m,std_m\n"
                "0.5,1,GPS,30,40,1.4e7,0.3e7,2.2e7,2e7,5\n");
  const Drive drive = read_drive(folder_.path());
  ASSERT_EQ(drive.measurements.size(), 3u);
  EXPECT_DOUBLE_EQ(stamp_of(drive.measurements[1].measurement), 0.5);
  EXPECT_TRUE(std::holds_alternative<PseudorangeEpoch>(drive.measurements[1].measurement));
  EXPECT_EQ(drive.fixes().size(), 2u);
}

TEST_F(ReadDrive, WithoutTruthNothingIsScored) {
  EXPECT_TRUE(read_drive(folder_.path()).notices.empty());
  std::filesystem::remove(folder_.path() + "/truth.csv");
  const Drive drive = read_drive(folder_.path());
  EXPECT_TRUE(drive.truth.empty());
  EXPECT_EQ(drive.notices, std::vector<std::string>{"no truth, nothing is scored"});
  EXPECT_DOUBLE_EQ(drive.start(), -1e-3);
}

TEST_F(ReadDrive, WithoutOdometryMotionIsByDoppler) {
  const LocalFrame map({50.0, 10.0, 100.0});
  const Eigen::Vector2d velocity(1.2, -0.9);
  std::ostringstream rows;
  rows.precision(15);
  rows
      << "t,sat_id,system,elevation_deg,cn0_dbhz,sat_x,sat_y,sat_z,pseudorange_m,std_m,range_rate_mps,sat_vx,"
         "sat_vy,sat_vz\n";
  for (int t = 0; t < 4; ++t) {
    for (const SatelliteObservation& one : observed(open_sky(), Eigen::Vector3d::Zero(), 50.0, 60.0)) {
      const Eigen::Vector3d ecef = map.satellite_to_ecef(one.position);
      const Eigen::Vector3d speed = map.vector_to_ecef(one.velocity);
      const Eigen::Vector3d direction = one.position.normalized();
      const double rate = map.satellite_velocity_to_map(ecef, speed).dot(direction) -
                          velocity.dot(direction.head<2>()) - 30.0;
      rows << t << "," << one.satellite << "," << to_string(one.constellation) << ",30,40," << ecef.x() << ","
           << ecef.y() << "," << ecef.z() << "," << one.pseudorange << ",5,";
      if (t != 2) rows << rate << "," << speed.x() << "," << speed.y() << "," << speed.z() << "\n";
      if (t == 2) rows << ",,,\n";
    }
  }
  folder_.write("pseudoranges.csv", rows.str());
  std::filesystem::remove(folder_.path() + "/odometry.csv");
  const Drive drive = read_drive(folder_.path());
  ASSERT_EQ(drive.odometry.size(), 4u);
  EXPECT_DOUBLE_EQ(drive.odometry[3].stamp, 3.0);
  EXPECT_DOUBLE_EQ(drive.odometry[3].duration, 1.0);
  for (const OdometryIncrement& increment : drive.odometry) {
    EXPECT_NEAR(increment.speed, 1.5, 1e-3);
    EXPECT_NEAR(increment.yaw_rate, 0.0, 1e-3);
  }
  ASSERT_EQ(drive.notices.size(), 2u);
  EXPECT_EQ(drive.notices[0], "no odometry.csv, motion is by Doppler velocity");
  EXPECT_EQ(drive.notices[1],
            "of 4 epochs 1 have no Doppler velocity: the last one is held, for 1 s at the longest");
}

TEST_F(ReadDrive, RefusesWithFileLineAndReason) {
  folder_.write("odometry.csv", "t,vx,wz\n0,1,0\n0,1,0\n");
  EXPECT_EQ(failure(), folder_.path() + "/odometry.csv:3: t does not increase");
  folder_.write("odometry.csv", "t,vx\n0,1\n1,1\n");
  EXPECT_EQ(failure(), folder_.path() + "/odometry.csv:1: no column wz");
  folder_.write("odometry.csv", kOdometry);
  folder_.write("fix.csv", "t,lat_deg,lon_deg,cov_ee_m2,cov_en_m2,cov_nn_m2\n0,50,10,1,0,\n");
  EXPECT_EQ(failure(), folder_.path() + "/fix.csv:2: cov_nn_m2 is '', not a finite number");
  folder_.write("fix.csv", kFixes);
  folder_.write("truth.csv", "t,lat_deg,lon_deg\n0,91,10\n");
  EXPECT_EQ(failure(), folder_.path() + "/truth.csv:2: latitude, longitude or altitude out of range");
  folder_.write("truth.csv", "t,lat_deg,lon_deg,alt_m\n0,50,10,1e308\n");
  EXPECT_EQ(failure(), folder_.path() + "/truth.csv:2: latitude, longitude or altitude out of range");
  folder_.write("truth.csv", kTruth);
  std::filesystem::remove(folder_.path() + "/fix.csv");
  EXPECT_EQ(failure(), folder_.path() + ": neither fix.csv nor pseudoranges.csv");
  folder_.write("fix.csv", kFixes);
  std::filesystem::remove(folder_.path() + "/odometry.csv");
  EXPECT_EQ(failure(), folder_.path() + ": neither odometry.csv nor velocity by Doppler");
}

TEST_F(ReadDrive, RefusesNumbersThatDifferencesAndMeansOfWouldOverflow) {
  folder_.write("odometry.csv", "t,vx,wz\n-1.7e308,1,0\n1.7e308,1,0\n");
  EXPECT_EQ(failure(), folder_.path() + "/odometry.csv:2: t is '-1.7e308', beyond 1e+11");
  folder_.write("odometry.csv", "t,vx,wz\n0,1e308,0\n1,1e308,0\n");
  EXPECT_EQ(failure(), folder_.path() + "/odometry.csv:2: vx is '1e308', beyond 1000");
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
