#include <gtest/gtest.h>

#include "evaluation/standings.hpp"

namespace multipath_localization {
namespace {

RunRecord run_of(const std::string& estimator, std::uint64_t seed, const std::string& kind, double rmse,
                 double nees, double beyond) {
  RunRecord run;
  run.source = "random";
  run.estimator = estimator;
  run.seed = seed;
  run.kind = kind;
  run.about = "robot " + std::to_string(seed);
  run.score.rmse = rmse;
  run.score.nees_mean = nees;
  run.longest_beyond_3_sigma = beyond;
  run.fixes.rmse = 4.0;
  run.cpu = 0.5;
  return run;
}

/// Two drives: on the first ours is the best, on the second gated_ekf.
std::vector<RunRecord> two_drives() {
  return {run_of("ours", 1, "rtk", 1.0, 2.0, 0.0),      run_of("ours", 2, "plain", 4.0, 7.0, 31.0),
          run_of("gated_ekf", 1, "rtk", 2.0, 8.0, 6.0), run_of("gated_ekf", 2, "plain", 1.0, 1.0, 0.0),
          run_of("oracle", 1, "rtk", 0.5, 2.0, 0.0),    run_of("oracle", 2, "plain", 0.5, 2.0, 0.0)};
}

TEST(Standings, AreGeometricMeansAndShares) {
  const std::vector<Standing> all = standings(two_drives(), "");
  ASSERT_EQ(all.size(), 4u);
  EXPECT_NEAR(*all[0].rmse, 4.0, 1e-12);  // the fixes
  EXPECT_FALSE(all[0].overconfident);
  const Standing& ours = all[1];
  EXPECT_EQ(ours.estimator, "ours");
  EXPECT_EQ(ours.drives, 2u);
  EXPECT_EQ(ours.scored, 2u);
  EXPECT_NEAR(*ours.rmse, 2.0, 1e-12);
  EXPECT_NEAR(*ours.to_best, std::sqrt(0.5 * 4.0), 1e-12);
  EXPECT_NEAR(*ours.to_oracle, 4.0, 1e-12);
  EXPECT_NEAR(*ours.behind, 0.5, 1e-12);
  EXPECT_NEAR(*ours.overconfident, 0.5, 1e-12);
  EXPECT_NEAR(*ours.beyond_5, 0.5, 1e-12);
  EXPECT_NEAR(*ours.beyond_30, 0.5, 1e-12);
  EXPECT_NEAR(ours.cpu, 1.0, 1e-12);
  EXPECT_NEAR(*all[2].to_best, std::sqrt(0.5 * 0.25), 1e-12);  // gated_ekf is not compared with itself
}

TEST(Standings, CountOneKindAlone) {
  const std::vector<Standing> plain = standings(two_drives(), "plain");
  EXPECT_EQ(plain[1].drives, 1u);
  EXPECT_NEAR(*plain[1].to_best, 4.0, 1e-12);
}

TEST(Standings, ARunWithoutAScoreIsBehind) {
  std::vector<RunRecord> runs = two_drives();
  runs[0].failure = "it broke";
  const Standing ours = standings(runs, "")[1];
  EXPECT_EQ(ours.scored, 1u);
  EXPECT_NEAR(*ours.behind, 1.0, 1e-12);
}

TEST(Standings, TheWorstDriveComesFirstWithWhatItIs) {
  const std::vector<RunRecord> runs = two_drives();
  const std::vector<Comparison> worst = worst_first(runs);
  ASSERT_EQ(worst.size(), 2u);
  EXPECT_EQ(worst[0].run->seed, 2u);
  EXPECT_EQ(worst[0].best, "gated_ekf");
  EXPECT_NEAR(worst[0].ratio, 4.0, 1e-12);
  const std::string text = describe_standings(runs);
  EXPECT_NE(text.find("random 2: 4.00 m, 4.00 times gated_ekf; NEES 7.0, outside 3 sigma for 31 s; robot 2"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("plain"), std::string::npos);
}

}  // namespace
}  // namespace multipath_localization
