#include <gtest/gtest.h>

#include "evaluation/random_suite.hpp"
#include "evaluation/report.hpp"

namespace multipath_localization {
namespace {

Batch batch_of(std::size_t jobs) {
  Batch batch;
  batch.source = "random";
  batch.estimators = {{"gated_ekf", "gated_ekf", ""}, {"two_stage_ekf", "two_stage_ekf", ""}};
  batch.first_seed = 3;
  batch.seeds = 3;
  batch.jobs = jobs;
  batch.score_from = 60.0;
  return batch;
}

/// The runs as JSON, without their processor times.
std::string results(std::size_t jobs) {
  std::vector<RunRecord> runs = run_random(batch_of(jobs), {}, {"{}", "{}"}, nullptr);
  for (RunRecord& run : runs) run.cpu = 0.0;
  return to_json(runs);
}

TEST(RandomSuite, RunsEveryEstimatorAndTheOracleWithEverySeed) {
  const std::vector<RunRecord> runs = run_random(batch_of(1), {}, {"{}", "{}"}, nullptr);
  ASSERT_EQ(runs.size(), 9u);
  EXPECT_EQ(runs[0].estimator, "gated_ekf");
  EXPECT_EQ(runs[3].estimator, "two_stage_ekf");
  EXPECT_EQ(runs[6].estimator, kOracle);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].seed, 3 + i % 3);
    EXPECT_TRUE(runs[i].score.rmse) << runs[i].failure;
    EXPECT_FALSE(runs[i].kind.empty());
    EXPECT_EQ(runs[i].about, runs[i % 3].about);
  }
}

TEST(RandomSuite, ResultsAreTheSameForAnyNumberOfJobs) { EXPECT_EQ(results(1), results(3)); }

}  // namespace
}  // namespace multipath_localization
