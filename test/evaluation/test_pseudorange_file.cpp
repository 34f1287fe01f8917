#include <gtest/gtest.h>

#include <cstdio>

#include "evaluation/pseudorange_file.hpp"
#include "temporary_folder.hpp"

namespace multipath_localization {
namespace {

const Geodetic kAntenna{52.5, 13.4, 80.0};
constexpr double kClock = -136902.0;
const char* const kHeader = "t,sat_id,system,elevation_deg,cn0_dbhz,sat_x,sat_y,sat_z,pseudorange_m,std_m\n";

/// One line of a satellite seen from the antenna in direction (east, north, up).
std::string line(double t, int satellite, const char* system, const Eigen::Vector3d& direction) {
  const LocalFrame frame(kAntenna);
  const Eigen::Vector3d in_map = 2.2e7 * direction.normalized();
  const Eigen::Vector3d ecef = frame.satellite_to_ecef(in_map);
  char text[300];
  std::snprintf(text, sizeof(text), "%.3f,%d,%s,%.4f,44,%.4f,%.4f,%.4f,%.4f,5\n", t, satellite, system,
                std::asin(in_map.normalized().z()) * 57.29577951308232, ecef.x(), ecef.y(), ecef.z(),
                in_map.norm() + kClock);
  return text;
}

std::string epoch(double t) {
  return line(t, 1, "GPS", {1.0, 0.0, 0.5}) + line(t, 2, "GPS", {-1.0, 0.2, 0.7}) +
         line(t, 3, "GPS", {0.1, 1.0, 0.4}) + line(t, 4, "gps", {0.0, -1.0, 1.0}) +
         line(t, 7, "GLONASS", {0.0, 0.0, 1.0});
}

class ReadPseudoranges : public ::testing::Test {
 protected:
  [[nodiscard]] std::string failure(const std::string& content) const {
    try {
      (void)PseudorangeFile(folder_.write("pseudoranges.csv", content)).epochs(LocalFrame(kAntenna));
    } catch (const DriveError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(ReadPseudoranges, LinesOfEqualTimeAreAnEpoch) {
  const PseudorangeFile file(folder_.write("p.csv", kHeader + epoch(0.0) + epoch(0.3)));
  const auto epochs = file.epochs(LocalFrame(kAntenna));
  ASSERT_EQ(epochs.size(), 2u);
  const auto& second = std::get<PseudorangeEpoch>(epochs[1].measurement);
  EXPECT_DOUBLE_EQ(second.stamp, 0.3);
  EXPECT_DOUBLE_EQ(epochs[1].arrival, 0.3);
  ASSERT_EQ(second.observations.size(), 5u);
  const SatelliteObservation& glonass = second.observations[4];
  EXPECT_EQ(glonass.constellation, Constellation::kGlonass);
  EXPECT_EQ(glonass.satellite, 7);
  EXPECT_NEAR(glonass.elevation, 1.5707963, 1e-5);
  EXPECT_DOUBLE_EQ(glonass.cn0, 44.0);
  EXPECT_DOUBLE_EQ(glonass.sigma, 5.0);
  EXPECT_LT((glonass.position - Eigen::Vector3d(0.0, 0.0, 2.2e7)).norm(), 1e-3);
  EXPECT_NEAR(glonass.pseudorange, glonass.position.norm() + kClock, 1e-3);
  EXPECT_FALSE(glonass.has_doppler());
}

TEST_F(ReadPseudoranges, FirstPositionIsThatOfTheFirstEpochWithEnoughSatellites) {
  const std::string few = line(0.0, 1, "GPS", {1.0, 0.0, 0.5});
  const Geodetic point = PseudorangeFile(folder_.write("p.csv", kHeader + few + epoch(0.3))).first_position();
  EXPECT_NEAR(point.latitude_deg, kAntenna.latitude_deg, 1e-7);
  EXPECT_NEAR(point.longitude_deg, kAntenna.longitude_deg, 1e-7);
  EXPECT_NEAR(point.altitude, kAntenna.altitude, 0.01);
  EXPECT_THROW((void)PseudorangeFile(folder_.write("p.csv", kHeader + few)).first_position(), DriveError);
}

TEST_F(ReadPseudoranges, TakesRangeRatesWhereTheyAre) {
  const PseudorangeFile file(folder_.write(
      "p.csv",
      "t,sat_id,system,elevation_deg,cn0_dbhz,sat_x,sat_y,sat_z,pseudorange_m,std_m,range_rate_mps,sat_vx,"
      "sat_vy,"
      "sat_vz\n0,1,GPS,30,40,1e7,1e7,2e7,2e7,5,-300,1,2,3\n0,2,GPS,30,,1e7,2e7,1e7,2e7,5,,,,\n"));
  const LocalFrame map(kAntenna);
  const auto observations = std::get<PseudorangeEpoch>(file.epochs(map)[0].measurement).observations;
  EXPECT_DOUBLE_EQ(observations[0].range_rate, -300.0);
  const Eigen::Vector3d velocity = map.satellite_velocity_to_map({1e7, 1e7, 2e7}, {1.0, 2.0, 3.0});
  EXPECT_LT((observations[0].velocity - velocity).norm(), 1e-9);
  EXPECT_FALSE(observations[1].has_doppler());
  EXPECT_TRUE(std::isnan(observations[1].cn0));
}

TEST_F(ReadPseudoranges, RefusesWithFileLineAndReason) {
  const std::string file = folder_.path() + "/pseudoranges.csv";
  EXPECT_EQ(failure(kHeader + epoch(0.3) + epoch(0.0)), file + ":7: t decreases");
  EXPECT_EQ(failure(kHeader + std::string("0,1,SPUTNIK,1,1,1,1,1,1,1\n")),
            file + ":2: unknown system 'SPUTNIK'");
  EXPECT_EQ(failure(kHeader + std::string("0,1,GPS,1,1,1,1,1,1,0\n")), file + ":2: std_m is not above 0");
  EXPECT_EQ(failure(kHeader + std::string("0,1,GPS,1,1,1,nan,1,1,1\n")),
            file + ":2: sat_y is 'nan', not a finite number");
  EXPECT_EQ(
      failure("t,sat_id,system,elevation_deg,cn0_dbhz,sat_x,sat_y,sat_z,pseudorange_m,std_m,range_rate_mps\n"
              "0,1,GPS,30,40,1e7,1e7,2e7,2e7,5,-300\n"),
      file + ":2: there is no column sat_vx");
}

TEST_F(ReadPseudoranges, RefusesWhatNoSatelliteIs) {
  const std::string file = folder_.path() + "/pseudoranges.csv";
  const auto with = [](const std::string& number, const std::string& position) {
    return kHeader + ("0," + number + ",GPS,30,40," + position + ",2e7,5\n");
  };
  EXPECT_EQ(failure(with("7", "1e7,1e7,2e7")), "");
  EXPECT_EQ(failure(with("1e300", "1e7,1e7,2e7")), file + ":2: sat_id is '1e300', beyond 65535");
  EXPECT_EQ(failure(with("1.5", "1e7,1e7,2e7")), file + ":2: sat_id is not a whole number");
  EXPECT_EQ(failure(with("7", "1e7,1e308,2e7")), file + ":2: sat_y is '1e308', beyond 1e+08");
  EXPECT_EQ(failure(with("7", "1,1,1")), file + ":2: no satellite's orbit is at sat_x, sat_y, sat_z");
}

}  // namespace
}  // namespace multipath_localization
