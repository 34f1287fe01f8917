#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "evaluation/closed_loop.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "noisy_drive.hpp"
#include "ros/localization_node/localization_parameters.hpp"
#include "tools/tuning/tuning.hpp"

namespace multipath_localization {
namespace {

/// What the localization node makes of the YAML; throws where it is not for it.
GnssParameters gnss_parameters(const std::string& yaml) {
  return LocalizationSettings::from(YAML::Load(yaml)).parameters.gnss;
}

/// The same of the default filter.
YAML::Node filter_parameters(const std::string& yaml) {
  const LocalizationSettings settings = LocalizationSettings::from(YAML::Load(yaml));
  make_estimator(estimator_names().front(), settings.estimator_parameters, 1);
  return settings.estimator_parameters;
}

Drive street(std::uint64_t seed) {
  const Scenario scenario = load_scenario(std::string(CONFIG_DIR) + "/scenarios/street.yaml");
  const auto make = [seed] { return make_estimator(estimator_names().front(), {}, seed); };
  return run_scenario(scenario, seed, make, {}).drive;
}

TEST(Tuning, PicksTheOpenSkyOfAStreet) {
  const Tuning tuning = tune(street(1));
  EXPECT_TRUE(tuning.open_sky);
  EXPECT_LT(tuning.fit.fixes, tuning.fixes * 7 / 10);
  EXPECT_TRUE(tuning.fit.white.told());
  EXPECT_NEAR(tuning.fit.white.value, 0.4, 0.1);  // of the scenario, a metre in shadow
  EXPECT_TRUE(tuning.fit.yaw.high_told);
  EXPECT_LT(tuning.fit.yaw.low, 0.0028);  // 0.02 rad/s at 50 Hz
  EXPECT_GT(tuning.fit.yaw.high, 0.0028);
  EXPECT_LT(tuning.fit.yaw.high, 0.02);
  EXPECT_NO_THROW(filter_parameters(to_yaml(tuning)));
}

TEST(Tuning, ClaimsNoDelayWhereAnAntennaElsewhereExplainsItAsWell) {
  int claims = 0;  // of intervals of 95 %, which may well miss zero for once
  int written = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Tuning tuning = tune(street(seed));  // fixes are late, their stamps are right
    claims += tuning.fit.delay.low > 0.0 || tuning.fit.delay.high < 0.0 ? 1 : 0;
    written += gnss_parameters(to_yaml(tuning)).delay != 0.0 ? 1 : 0;
  }
  EXPECT_LE(claims, 1);
  EXPECT_LE(written, claims) << "what is not told is not written";
}

TEST(Tuning, WritesADelayThatIsOne) {
  Tuning tuning;
  tuning.open_sky = true;
  tuning.fit.white = {0.05, 0.048, 0.052, true, true};
  tuning.fit.delay = {0.3, 0.25, 0.35, true, true};
  tuning.fit.antenna_ahead = {0.0, -0.1, 0.1, true, true};
  EXPECT_EQ(gnss_parameters(to_yaml(tuning)).delay, 0.3);
  tuning.fit.delay = {0.03, -0.05, 0.11, true, true};
  EXPECT_EQ(gnss_parameters(to_yaml(tuning)).delay, 0.0);
  EXPECT_NE(to_yaml(tuning).find("which may be none"), std::string::npos);
}

TEST(Tuning, WritesNoDelayThatTheNodeWouldRefuseFixesWith) {
  Tuning tuning;
  tuning.open_sky = true;
  tuning.fit.white = {0.05, 0.048, 0.052, true, true};
  tuning.fit.antenna_ahead = {0.0, -0.1, 0.1, true, true};
  tuning.fit.delay = {-0.6, -0.65, -0.55, true, true};
  EXPECT_EQ(gnss_parameters(to_yaml(tuning)).delay, 0.0);
  EXPECT_NE(to_yaml(tuning).find("set the clocks"), std::string::npos);
}

TEST(Tuning, WritesNoScaleThatTheNodeRefuses) {
  Tuning tuning;
  tuning.open_sky = true;
  tuning.fit.white = {0.05, 0.048, 0.052, true, true};
  tuning.fit.scale = {0.9, 0.01};
  EXPECT_NO_THROW(filter_parameters(to_yaml(tuning)));
  EXPECT_NE(to_yaml(tuning).find("# scale_sigma: it is 0.9"), std::string::npos);
}

TEST(Tuning, SaysBothWhereDelayAndAntennaLookAlike) {
  Tuning tuning;
  tuning.open_sky = true;
  tuning.fit.white = {0.05, 0.048, 0.052, true, true};
  tuning.fit.way = 100.0;
  tuning.fit.moving_time = 100.0;
  tuning.fit.delay = {-0.6, -5.0, 4.0, false, false};
  tuning.fit.antenna_ahead = {0.3, -5.0, 5.0, false, false};
  EXPECT_NE(to_yaml(tuning).find("not told by this bag: drive a figure of eight"), std::string::npos);
  tuning.fit.behind = {-0.9, -1.0, -0.8, true, true};
  const std::string yaml = to_yaml(tuning);
  EXPECT_EQ(gnss_parameters(yaml).delay, 0.0);
  EXPECT_NE(yaml.find("fixes are 0.90 m ahead"), std::string::npos);
  EXPECT_NE(yaml.find("delay of -0.900 s or by an antenna 0.90 m further ahead"), std::string::npos);
}

TEST(Tuning, WritesWhatIsToldAndKeepsTheDefaultElsewhere) {
  Tuning tuning;
  tuning.open_sky = true;
  tuning.fit.yaw = {0.02, 0.015, 0.03, true, true};
  tuning.fit.distance = {0.0001, 0.0001, 0.03, false, true};
  tuning.fit.white = {0.05, 0.048, 0.052, true, true};
  tuning.fit.wander = {0.001, 0.001, 0.1, false, true};
  tuning.fit.wander_time = {1.0, 1.0, 3000.0, false, false};
  tuning.fit.scale = {-0.05, 0.002};
  const std::string yaml = to_yaml(tuning);
  const YAML::Node filter = filter_parameters(yaml);
  EXPECT_EQ(filter["odometry"]["yaw"].as<double>(), 0.02);
  EXPECT_EQ(filter["odometry"]["distance"].as<double>(), 0.005);
  EXPECT_EQ(filter["odometry"]["scale_sigma"].as<double>(), 0.052);
  EXPECT_EQ(filter["odometry"]["gyro_bias_sigma"].as<double>(), 0.004);
  EXPECT_NE(yaml.find("# errors of fixes under open sky: white 0.05 m"), std::string::npos);
  EXPECT_NE(yaml.find("distance: 0.005  # [m/sqrt(m)] not told by this bag: below 0.03"), std::string::npos);
  EXPECT_NE(yaml.find("delay, antenna: not told by this bag"), std::string::npos);
}

TEST(Tuning, SaysNothingActiveWhereFixesAndOdometryGoDifferentWays) {
  Drive drive = NoisyDrive().record(1);
  EXPECT_TRUE(tune(drive).alike);
  for (auto& recorded : drive.measurements) {
    auto& position = std::get<GnssFix>(recorded.measurement).position;
    position = {position.y(), 0.5 * position.x()};
  }
  const Tuning tuning = tune(drive);
  EXPECT_FALSE(tuning.alike);
  EXPECT_EQ(YAML::Load(to_yaml(tuning)).size(), 0U);
  EXPECT_NE(to_yaml(tuning).find("doctor --bag FILE says why"), std::string::npos);
}

TEST(Tuning, TakesASilenceOfOdometryForNoStandstill) {
  const Drive before = NoisyDrive().record(1);
  Drive drive = before;
  const double begin = 100.0, end = 112.0;  // the robot drives on
  auto& odometry = drive.odometry;
  odometry.erase(std::remove_if(odometry.begin(), odometry.end(),
                                [&](const auto& u) { return u.stamp > begin && u.stamp <= end; }),
                 odometry.end());
  drive.restarts = {end + 0.05};
  const Tuning tuning = tune(drive);
  EXPECT_EQ(tuning.parts, 2U);
  EXPECT_NEAR(tuning.fit.scale.value, 0.01, 0.005);
  EXPECT_LT(tuning.fit.yaw.value, 2.0 * tune(before).fit.yaw.value);
  EXPECT_NE(to_yaml(tuning).find("Of 2 parts between silences"), std::string::npos);
}

TEST(Tuning, LeavesOutWhatAFrozenReceiverRepeats) {
  Drive drive = NoisyDrive().record(1);
  for (std::size_t i = 1; i < 200; ++i) {
    std::get<GnssFix>(drive.measurements[i].measurement).position =
        std::get<GnssFix>(drive.measurements[0].measurement).position;
  }
  const Tuning tuning = tune(drive);
  EXPECT_EQ(tuning.fixes, drive.measurements.size() - 199);
  EXPECT_NEAR(tuning.fit.scale.value, 0.01, 0.01);
}

TEST(Tuning, SaysSoWhereNothingIsTold) {
  NoisyDrive robot;
  robot.duration = 5.0;
  const std::string yaml = to_yaml(tune(robot.record(1)));
  EXPECT_NE(yaml.find("Nothing told"), std::string::npos);
  EXPECT_NO_THROW(filter_parameters(yaml));
}

}  // namespace
}  // namespace multipath_localization
