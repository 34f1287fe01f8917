#include <gtest/gtest.h>

#include <limits>

#include "evaluation/trace.hpp"

namespace multipath_localization {
namespace {

TEST(ToTrace, CountsTimeFromTheStartAndLeavesOutWhatIsNotValid) {
  Drive drive;
  drive.odometry = {{101.0, 1.0, 0.0, 0.0}};
  drive.truth = {{100.0, {1.0, 2.0, 0.0}, false, true}, {101.0, {1.0, 2.0, 0.0}, false, false}};
  RunRecord run;
  run.estimator = "a{b: \"c\"}";
  run.epochs.resize(2);
  run.epochs[1].truth = drive.truth[1];
  run.epochs[1].valid = true;
  run.epochs[1].estimate = {4.0, 6.0, 0.0};
  RunRecord other_seed = run;
  other_seed.seed = 2;

  const YAML::Node trace = YAML::Load(to_trace("title", drive, {run, other_seed}));
  EXPECT_EQ(trace["title"].as<std::string>(), "title");
  EXPECT_EQ(trace["runs"][0]["estimator"].as<std::string>(), run.estimator);
  EXPECT_EQ(trace["runs"][0]["heading_errors_deg"]["t"].size(), 0u);
  EXPECT_EQ(trace["truth"]["shadow"].as<std::vector<int>>(), (std::vector<int>{1, 0}));
  ASSERT_EQ(trace["runs"].size(), 1u);
  EXPECT_EQ(trace["runs"][0]["t"].as<std::vector<double>>(), std::vector<double>{1.0});
  EXPECT_EQ(trace["runs"][0]["errors"]["error"].as<std::vector<double>>(), std::vector<double>{5.0});
  EXPECT_TRUE(trace["runs"][0]["rmse"].IsNull());
}

TEST(ToTrace, MeasuresFixesAtTheirAntennasAndHeadingsRoundTheCircle) {
  Drive drive;
  drive.odometry = {{101.0, 1.0, 0.0, 0.0}};
  drive.truth = {{100.0, {1.0, 2.0, 0.5 * kPi}, true, {}}, {101.0, {1.0, 2.0, kPi - 0.1}, true, {}}};
  GnssFix fix;
  fix.stamp = 100.0;
  fix.antenna_in_base = {0.5, 0.0};
  fix.position = {1.0, 2.6};
  drive.measurements.push_back({fix, fix.stamp});
  fix.stamp = 102.0;  // beyond truth
  drive.measurements.push_back({fix, fix.stamp});
  RunRecord run;
  run.epochs.resize(1);
  run.epochs[0].truth = drive.truth[1];
  run.epochs[0].valid = true;
  run.epochs[0].estimate.yaw = 0.1 - kPi;

  const YAML::Node trace = YAML::Load(to_trace("title", drive, {run}));
  EXPECT_EQ(trace["fixes"]["t"].size(), 2u);
  ASSERT_EQ(trace["fix_errors"]["error"].size(), 1u);
  EXPECT_NEAR(trace["fix_errors"]["error"][0].as<double>(), 0.1, 1e-9);
  EXPECT_NEAR(trace["runs"][0]["heading_errors_deg"]["error"][0].as<double>(), 0.2 * 180.0 / kPi, 1e-6);
}

TEST(ToTrace, TellsStatesCovariancesAndWhatBecameOfMeasurements) {
  Drive drive;
  drive.odometry = {{101.0, 1.0, 1.5, 0.0}};
  RunRecord run;
  run.epochs.resize(1);
  run.epochs[0].truth.stamp = 101.0;
  run.epochs[0].valid = true;
  run.epochs[0].state = Trust::kMultipath;
  run.epochs[0].position_covariance << 4.0, 1.0, 1.0, 9.0;
  const std::size_t fixes = Measurement(GnssFix()).index();
  run.weighings = {{101.5, fixes, Reason::kGated, 12.5},
                   {102.0, fixes, Reason::kNoFix, std::nullopt},
                   {102.5, fixes, Reason::kUnused, std::nullopt}};
  run.score.max = 3.5;

  const YAML::Node trace = YAML::Load(to_trace("title", drive, {run}));
  const YAML::Node drawn = trace["runs"][0];
  EXPECT_EQ(trace["odometry"]["speed"].as<std::vector<double>>(), std::vector<double>{1.5});
  EXPECT_EQ(drawn["state"][0].as<std::string>(), "MULTIPATH");
  EXPECT_EQ(drawn["covariance"]["xy"][0].as<double>(), 1.0);
  EXPECT_EQ(drawn["covariance"]["yy"][0].as<double>(), 9.0);
  EXPECT_EQ(drawn["weighings"]["t"].as<std::vector<double>>(), (std::vector<double>{1.5, 2.0}));
  EXPECT_EQ(drawn["weighings"]["kind"][0].as<std::string>(), "fix");
  EXPECT_EQ(drawn["weighings"]["reason"][0].as<std::string>(), to_string(Reason::kGated));
  EXPECT_EQ(drawn["weighings"]["nis"][0].as<double>(), 12.5);
  EXPECT_TRUE(drawn["weighings"]["nis"][1].IsNull());
  EXPECT_EQ(drawn["figures"]["max_m"].as<double>(), 3.5);
  EXPECT_FALSE(drawn["drive"]);
}

TEST(ToTrace, LeavesOutFixesThatAreNotFinite) {
  Drive drive;
  drive.odometry = {{101.0, 1.0, 0.0, 0.0}};
  GnssFix fix;
  fix.stamp = 101.0;
  fix.position = {1.0, std::numeric_limits<double>::quiet_NaN()};
  drive.measurements.push_back({fix, fix.stamp});
  EXPECT_EQ(YAML::Load(to_trace("title", drive, {RunRecord()}))["fixes"]["t"].size(), 0u);
}

TEST(ToTrace, TellsTheDriveOfARunThatWentAnotherWay) {
  RunRecord first;
  first.drive.odometry = {{101.0, 1.0, 0.0, 0.0}};
  first.drive.truth = {{101.0, {1.0, 2.0, 0.0}, false, {}}};
  RunRecord second = first;
  second.drive.truth[0].base_in_map.x = 7.0;

  const YAML::Node trace = YAML::Load(to_trace("title", Scenario(), {first, second}));
  EXPECT_EQ(trace["truth"]["x"][0].as<double>(), 1.0);
  EXPECT_FALSE(trace["runs"][0]["drive"]);
  EXPECT_EQ(trace["runs"][1]["drive"]["truth"]["x"][0].as<double>(), 7.0);
}

TEST(ToTrace, DrawsTheFirstSeedWhicheverItIs) {
  Drive drive;
  drive.odometry = {{101.0, 1.0, 0.0, 0.0}};
  RunRecord run;
  run.seed = 5;
  EXPECT_EQ(YAML::Load(to_trace("title", drive, {run}))["runs"].size(), 1u);
}

TEST(ToTrace, DrawsTheWayOfADriveWithoutTruth) {
  Drive drive;
  drive.odometry = {{101.0, 1.0, 0.0, 0.0}};
  RunRecord run;
  run.epochs.resize(1);
  run.epochs[0].truth.stamp = 101.0;
  run.epochs[0].valid = true;
  run.epochs[0].estimate = {4.0, 6.0, 0.0};

  const YAML::Node trace = YAML::Load(to_trace("title", drive, {run}));
  EXPECT_EQ(trace["runs"][0]["x"].as<std::vector<double>>(), std::vector<double>{4.0});
  EXPECT_EQ(trace["runs"][0]["errors"]["t"].size(), 0u);
  EXPECT_EQ(trace["truth"]["t"].size(), 0u);
}

}  // namespace
}  // namespace multipath_localization
