#include <gtest/gtest.h>

#include "evaluation/shortcomings.hpp"

namespace multipath_localization {
namespace {

RunRecord run(const std::string& source, const std::string& estimator, double rmse, double beyond = 0.0) {
  RunRecord record;
  record.source = source;
  record.estimator = estimator;
  record.score.rmse = rmse;
  record.longest_beyond_3_sigma = beyond;
  return record;
}

TEST(Shortcomings, AreNoneWhereTheFirstEstimatorIsNearTheBest) {
  EXPECT_TRUE(shortcomings({run("a", "own", 1.09), run("a", "other", 1.0)}).empty()) << "within 10 %";
  EXPECT_TRUE(shortcomings({run("a", "own", 0.14), run("a", "other", 0.1)}).empty()) << "within 0.05 m";
  EXPECT_TRUE(shortcomings({run("a", "own", 1.0, 4.9)}).empty());
  EXPECT_TRUE(shortcomings({}).empty());
}

TEST(Shortcomings, NameTheStreamAndTheBetterOneByMeans) {
  const std::vector<std::string> said =
      shortcomings({run("a", "own", 1.0), run("a", "own", 3.0), run("a", "other", 1.5),
                    run("a", "other", 2.1), run("b", "own", 1.0), run("b", "other", 2.0)});
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said.front(), "a: own has an RMSE of 2.00 m, other of 1.80 m");
}

TEST(Shortcomings, CountTheWorstSeedOfAConfidentWrongPose) {
  const std::vector<std::string> said = shortcomings({run("a", "own", 1.0, 1.0), run("a", "own", 1.0, 5.5)});
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said.front(), "a: own was outside its own 3 sigma for 5.50 s");
}

TEST(Shortcomings, IncludeRunsThatDidNotEnd) {
  RunRecord failed = run("a", "own", 1.0);
  failed.failure = "why";
  const std::vector<std::string> said = shortcomings({failed, run("a", "own", 1.0), run("a", "other", 1.0)});
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said.front(), "a: own gave nothing to score in 1 of 2 runs");
  EXPECT_EQ(shortcomings({failed, run("a", "other", 1.0)}).size(), 2U) << "and the other is better";
}

}  // namespace
}  // namespace multipath_localization
