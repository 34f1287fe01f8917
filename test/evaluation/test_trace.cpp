#include <gtest/gtest.h>

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
