#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "../core/german_locale.hpp"
#include "evaluation/drive.hpp"
#include "rinex/drive_writer.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const Geodetic kAntenna{35.1, 136.9, 100.0};

class WriteDrive : public ::testing::Test {
 protected:
  /// A receiver that stands for some seconds.
  void write(const std::string& directory, bool overwrite = false) const {
    PointPositioning positioning(navigation_, {0.1, {Constellation::kGps, Constellation::kGalileo}});
    const DriveSource source{
        "a 'strange' name.obs", {"one.nav", "two.nav"}, on_24_june(8, 20) + 0.3e-3, 5.0, true};
    DriveWriter writer(directory, source, overwrite);
    for (int second = 0; second < 4; ++second) {
      RawEpoch raw =
          heard(satellites_, kAntenna, on_24_june(8, 20, second), 0.3e-3, 1e-7, summer_ionosphere());
      raw.observations[0].cn0 = SatelliteObservation::kUnknown;
      raw.observations[1].doppler = SatelliteObservation::kUnknown;
      if (second == 3) raw.observations.resize(3);
      writer.add(*positioning.correct(raw));
    }
    writer.close();
  }

  static std::vector<BroadcastOrbit> two_systems() {
    std::vector<BroadcastOrbit> all = circling_satellites(Constellation::kGps, 6, 5);
    const auto galileo = circling_satellites(Constellation::kGalileo, 5, 5);
    all.insert(all.end(), galileo.begin(), galileo.end());
    return all;
  }

  const std::vector<BroadcastOrbit> satellites_ = two_systems();
  const Navigation navigation_ = navigation_of(satellites_);
  TemporaryFolder folder_;
};

TEST_F(WriteDrive, EvaluateReadsWhatIsWritten) {
  const std::string directory = folder_.path() + "/new/drive";
  write(directory);
  const Drive drive = read_drive(directory);
  ASSERT_EQ(drive.fixes().size(), 3u);
  EXPECT_DOUBLE_EQ(drive.fixes()[2].stamp, 2.0);
  EXPECT_LT(LocalFrame(kAntenna).to_map(drive.datum).norm(), 0.05);
  std::size_t epochs = 0;
  for (const RecordedMeasurement& recorded : drive.measurements) {
    const auto* epoch = std::get_if<PseudorangeEpoch>(&recorded.measurement);
    if (epoch == nullptr) continue;
    ++epochs;
    for (const SatelliteObservation& seen : epoch->observations) {
      EXPECT_NEAR(seen.pseudorange - seen.position.norm(), kSpeedOfLight * 0.3e-3, 0.1);
      if (seen.has_doppler()) {
        EXPECT_NEAR(seen.range_rate - seen.velocity.dot(seen.position.normalized()), kSpeedOfLight * 1e-7,
                    3e-3);
      }
    }
  }
  EXPECT_EQ(epochs, 4u);
  ASSERT_EQ(drive.odometry.size(), 4u);
  for (const OdometryIncrement& increment : drive.odometry) {
    EXPECT_EQ(increment.speed, 0.0);
    EXPECT_EQ(increment.yaw_rate, 0.0);
  }
}

TEST_F(WriteDrive, FixesSayTheirClocks) {
  write(folder_.path());
  for (const char* file : {"/fix.csv", "/robust_fix.csv"}) {
    const CsvTable fixes(folder_.path() + file, {"cov_uu_m2", "wrss", "dof", "isb_bds_m", "isb_qzs_m"});
    ASSERT_EQ(fixes.rows(), 3u);
    EXPECT_NEAR(fixes.number(2, "clock_m"), kSpeedOfLight * 0.3e-3, 0.01);
    EXPECT_NEAR(fixes.number(2, "isb_gal_m"), 0.0, 0.01);
    EXPECT_EQ(fixes.text(2, "isb_glo_m"), "");
    EXPECT_NEAR(fixes.number(2, "alt_m"), 100.0, 0.01);
    EXPECT_EQ(fixes.number(2, "num_sat") - fixes.number(2, "dof"), 5.0);
    EXPECT_GT(fixes.number(2, "cov_uu_m2"), 0.0);
  }
}

/// As from satellites without redundancy: kilometres off, which no residual tells.
TEST_F(WriteDrive, AFixOffTheWayHasNoStatus) {
  PointPositioning positioning(navigation_, {0.1, {Constellation::kGps, Constellation::kGalileo}});
  DriveWriter writer(folder_.path(), {"obs", {"nav"}, on_24_june(8, 20), 5.0, true}, false);
  for (int second = 0; second < 9; ++second) {
    Geodetic antenna = kAntenna;
    if (second == 4) antenna.latitude_deg += 0.036;
    const GnssTime time = on_24_june(8, 20, second);
    writer.add(*positioning.correct(heard(satellites_, antenna, time, 0.0, 0.0, summer_ionosphere())));
  }
  writer.close();
  EXPECT_EQ(writer.off_the_way(), std::vector<double>{4.0});
  for (const char* file : {"/fix.csv", "/robust_fix.csv"}) {
    const CsvTable fixes(folder_.path() + file, {"status"});
    ASSERT_EQ(fixes.rows(), 9u);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(fixes.number(i, "status"), i == 4 ? -1.0 : 0.0) << i;
  }
}

TEST_F(WriteDrive, DescriptionTellsTheTimeAndTheSource) {
  write(folder_.path());
  const YAML::Node description = YAML::LoadFile(folder_.path() + "/drive.yaml");
  EXPECT_EQ(description["gps_week"].as<int>(), 2320);
  EXPECT_NEAR(description["seconds_of_week"].as<double>(), 116400.0003, 1e-9);
  EXPECT_EQ(description["observations"].as<std::string>(), "a 'strange' name.obs");
  EXPECT_EQ(description["navigation"][1].as<std::string>(), "two.nav");
  EXPECT_EQ(description["elevation_mask_deg"].as<double>(), 5.0);
  EXPECT_EQ(description["ionosphere"].as<std::string>(), "klobuchar");
}

TEST_F(WriteDrive, WritesAlikeInAnyLocale) {
  const std::string plain = folder_.path() + "/plain";
  const std::string foreign = folder_.path() + "/foreign";
  write(plain);
  const GermanLocale german;
  write(foreign);
  for (const char* name : {"/pseudoranges.csv", "/fix.csv", "/robust_fix.csv", "/drive.yaml"}) {
    std::ifstream one(plain + name);
    std::ifstream other(foreign + name);
    EXPECT_TRUE(
        std::equal(std::istreambuf_iterator<char>(one), {}, std::istreambuf_iterator<char>(other), {}))
        << name;
  }
  EXPECT_EQ(read_drive(foreign).fixes().size(), 3U);
}

TEST_F(WriteDrive, OverwritesOnlyWhenAsked) {
  folder_.write("fix.csv", "recorded by hand\n");
  EXPECT_THROW(write(folder_.path()), RinexError);
  EXPECT_THROW(CsvTable(folder_.path() + "/fix.csv", {"t"}), DriveError);
  write(folder_.path(), true);
  EXPECT_EQ(CsvTable(folder_.path() + "/fix.csv", {"t"}).rows(), 3u);
}

TEST_F(WriteDrive, RefusesAPlaceThatCannotBeWritten) {
  const std::string file = folder_.write("file", "");
  EXPECT_THROW(write(file + "/drive"), RinexError);
}

}  // namespace
}  // namespace multipath_localization
