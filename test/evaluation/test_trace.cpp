#include <gtest/gtest.h>

#include "multipath_localization/evaluation/trace.hpp"

namespace multipath_localization {
namespace {

TEST(ToTrace, CountsTimeFromTheStartAndLeavesOutWhatIsNotValid) {
  Drive drive;
  drive.odometry = {{101.0, 1.0, 0.0, 0.0}};
  drive.truth = {{100.0, {1.0, 2.0, 0.0}, false, true}, {101.0, {1.0, 2.0, 0.0}, false, false}};
  RunRecord run;
  run.estimator = "a";
  run.epochs.resize(2);
  run.epochs[1].truth = drive.truth[1];
  run.epochs[1].valid = true;
  run.epochs[1].estimate = {4.0, 6.0, 0.0};
  RunRecord other_seed = run;
  other_seed.seed = 2;

  const YAML::Node trace = YAML::Load(to_trace("title", drive, {run, other_seed}));
  EXPECT_EQ(trace["title"].as<std::string>(), "title");
  EXPECT_EQ(trace["truth"]["shadow"].as<std::vector<int>>(), (std::vector<int>{1, 0}));
  ASSERT_EQ(trace["runs"].size(), 1u);
  EXPECT_EQ(trace["runs"][0]["t"].as<std::vector<double>>(), std::vector<double>{1.0});
  EXPECT_EQ(trace["runs"][0]["error"].as<std::vector<double>>(), std::vector<double>{5.0});
  EXPECT_TRUE(trace["runs"][0]["rmse"].IsNull());
}

}  // namespace
}  // namespace multipath_localization
