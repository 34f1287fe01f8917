#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cmath>
#include <cstdio>

#include "../../evaluation/temporary_folder.hpp"
#include "evaluation/batch.hpp"
#include "evaluation/report.hpp"
#include "good_epoch.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "ros/bags/bag_drive.hpp"
#include "ros/bags/bag_writer.hpp"

namespace multipath_localization {
namespace {

template <class... Numbers>
std::string line(const char* format, Numbers... numbers) {
  char text[300];
  std::snprintf(text, sizeof(text), format, numbers...);
  return text;
}

/// One satellite at t as pseudoranges.csv has it, seen from `antenna` in map.
std::string satellite_line(double t, const SatelliteObservation& satellite) {
  const Eigen::Vector3d ecef = berlin().satellite_to_ecef(satellite.position);
  return line("%.1f,%d,%s,%.4f,%.1f,%.4f,%.4f,%.4f,%.4f,5\n", t, satellite.satellite,
              std::string(to_string(satellite.constellation)).c_str(), satellite.elevation * 180.0 / kPi,
              satellite.cn0, ecef.x(), ecef.y(), ecef.z(), satellite.pseudorange);
}

/// Forty seconds round a circle, everything at 5 Hz, biased in the second half.
void write_drive(const TemporaryFolder& folder, double start) {
  std::string odometry = "t,vx,wz\n";
  std::string fix = "t,lat_deg,lon_deg,alt_m,cov_ee_m2,cov_en_m2,cov_nn_m2\n";
  std::string pseudoranges = "t,sat_id,system,elevation_deg,cn0_dbhz,sat_x,sat_y,sat_z,pseudorange_m,std_m\n";
  std::string truth = "t,lat_deg,lon_deg,alt_m,yaw,shadow\n";
  RandomStream random(3, 0, 0);
  for (int i = 0; i <= 200; ++i) {
    const double t = start + 0.2 * i;
    const double yaw = wrap_angle(0.02 * i);
    const Eigen::Vector2d position(20.0 * std::sin(yaw), 20.0 - 20.0 * std::cos(yaw));
    const Eigen::Vector2d error = i < 100 ? Eigen::Vector2d(0.0, 0.0) : Eigen::Vector2d(4.0, -2.0);
    const Eigen::Vector2d noise(0.3 * random.normal(), 0.3 * random.normal());
    const Geodetic true_place = berlin().to_geodetic(position);
    const Geodetic place = berlin().to_geodetic(position + error + noise);
    odometry += line("%.1f,2.02,0.101\n", t);
    fix += line("%.1f,%.9f,%.9f,%.4f,0.09,0.01,0.09\n", t, place.latitude_deg, place.longitude_deg, 40.0);
    truth += line("%.1f,%.9f,%.9f,40,%.6f,%d\n", t, true_place.latitude_deg, true_place.longitude_deg, yaw,
                  i < 100 ? 0 : 1);
    const Eigen::Vector3d antenna(position.x(), position.y(), 0.0);
    for (const SatelliteObservation& satellite : observed(open_sky(), antenna, -136902.0, -136897.0)) {
      pseudoranges += satellite_line(t, satellite);
    }
  }
  folder.write("odometry.csv", odometry);
  folder.write("fix.csv", fix);
  folder.write("pseudoranges.csv", pseudoranges);
  folder.write("truth.csv", truth);
}

std::string table_of(const Drive& drive) {
  Batch batch;
  for (const std::string& name : estimator_names()) batch.estimators.push_back({name, name, ""});
  std::vector<RunRecord> runs =
      run_batch(batch, drive, parameters_of(batch, drive, ParameterOverrides({}, {})), nullptr);
  for (RunRecord& run : runs) run.cpu = 0.0;
  return to_table(runs);
}

class WriteBag : public ::testing::Test {
 protected:
  WriteBag() : drive_(drive_from(0.0)) {}

  Drive drive_from(double start) {
    write_drive(folder_, start);
    return read_drive(folder_.path());
  }

  Drive through_bag(const Drive& drive) {
    write_bag(drive, folder_.path() + "/drive.bag");
    return read_bag(folder_.path() + "/drive.bag", {}, std::nullopt);
  }

  TemporaryFolder folder_;
  Drive drive_;
};

TEST_F(WriteBag, KeepsEverythingAReaderWants) {
  const Drive back = through_bag(drive_);
  EXPECT_TRUE(back.notices.empty()) << back.notices.front();
  EXPECT_NEAR(back.datum.latitude_deg, drive_.datum.latitude_deg, 1e-12);
  ASSERT_EQ(back.odometry.size(), drive_.odometry.size());
  ASSERT_EQ(back.measurements.size(), 402u);
  ASSERT_EQ(back.truth.size(), drive_.truth.size());
  for (std::size_t i = 0; i < back.measurements.size(); ++i) {
    EXPECT_EQ(back.measurements[i].measurement.index(), drive_.measurements[i].measurement.index()) << i;
    EXPECT_NEAR(back.measurements[i].arrival, drive_.measurements[i].arrival + 1.0, 1e-9) << "no time zero";
  }
  const auto& epoch = std::get<PseudorangeEpoch>(back.measurements[1].measurement);
  const auto& original = std::get<PseudorangeEpoch>(drive_.measurements[1].measurement);
  ASSERT_EQ(epoch.observations.size(), 13u);
  EXPECT_LT((epoch.observations[7].position - original.observations[7].position).norm(), 1e-6);
  EXPECT_EQ(epoch.observations[7].pseudorange, original.observations[7].pseudorange);
  EXPECT_NEAR(back.odometry[10].duration, 0.2, 1e-9);
  EXPECT_TRUE(back.truth[0].has_yaw);
  EXPECT_EQ(back.truth[99].shadow, false);
  EXPECT_EQ(back.truth[100].shadow, true);
}

TEST_F(WriteBag, EvaluatesToTheSameFigures) {
  const Drive drive = drive_from(1000.0);
  const std::string table = table_of(drive);
  EXPECT_NE(table.find("201"), std::string::npos) << "epochs are scored:\n" << table;
  EXPECT_EQ(table_of(through_bag(drive)), table);
}

TEST_F(WriteBag, KeepsStampsThatRosKnows) {
  for (OdometryIncrement& increment : drive_.odometry) increment.stamp += 1e9;
  for (TruthSample& truth : drive_.truth) truth.stamp += 1e9;
  drive_.measurements.clear();
  GnssFix fix;
  fix.stamp = 1e9 + 7.25;
  drive_.measurements.push_back({fix, fix.stamp});
  EXPECT_DOUBLE_EQ(through_bag(drive_).fixes().at(0).stamp, 1e9 + 7.25);
}

TEST_F(WriteBag, KeepsPairsAndTheirAntennas) {
  drive_.measurements.clear();
  DualAntennaFix fixes;
  fixes.stamp = fixes.left.stamp = fixes.right.stamp = 3.0;
  fixes.left.position = {1.0, 2.0};
  fixes.left.antenna_in_base = {0.2, 0.5};
  fixes.right.antenna_in_base = {0.2, -0.5};
  drive_.measurements.push_back({fixes, 3.0});
  const Drive back = through_bag(drive_);
  ASSERT_EQ(back.measurements.size(), 1u);
  const auto& read = std::get<DualAntennaFix>(back.measurements[0].measurement);
  EXPECT_LT((read.left.position - fixes.left.position).norm(), 1e-6);
  EXPECT_EQ(read.left.antenna_in_base, fixes.left.antenna_in_base);
  EXPECT_EQ(read.right.antenna_in_base, fixes.right.antenna_in_base);
}

TEST_F(WriteBag, SaysWhereItCannotWrite) {
  EXPECT_THROW(write_bag(drive_, folder_.path() + "/nowhere/drive.bag"), DriveError);
}

}  // namespace
}  // namespace multipath_localization
