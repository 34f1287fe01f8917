#include <gtest/gtest.h>

#include "evaluation/random_suite.hpp"
#include "evaluation/report.hpp"

namespace multipath_localization {
namespace {

const std::vector<std::uint64_t> kSeeds = {3, 4, 5};

Batch batch_of(std::size_t jobs) {
  Batch batch;
  batch.source = "random";
  batch.estimators = {{"gated_ekf", "gated_ekf", ""}, {"two_stage_ekf", "two_stage_ekf", ""}};
  batch.jobs = jobs;
  batch.score_from = 60.0;
  return batch;
}

/// The runs as JSON, without their processor times.
std::string results(std::size_t jobs) {
  std::vector<RunRecord> runs = run_random(batch_of(jobs), kSeeds, {}, {"{}", "{}"}, nullptr);
  for (RunRecord& run : runs) run.cpu = 0.0;
  return to_json(runs);
}

TEST(RandomSuite, RunsEveryEstimatorAndTheOracleWithEverySeed) {
  std::size_t ended = 0;
  const std::vector<RunRecord> runs =
      run_random(batch_of(1), kSeeds, {}, {"{}", "{}"}, nullptr,
                 [&](const std::vector<RunRecord>& of_seed) { ended += of_seed.size(); });
  ASSERT_EQ(runs.size(), 9u);
  EXPECT_EQ(ended, 9u);
  EXPECT_EQ(runs[0].estimator, "gated_ekf");
  EXPECT_EQ(runs[1].estimator, "two_stage_ekf");
  EXPECT_EQ(runs[2].estimator, kOracle);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].seed, kSeeds[i / 3]);
    EXPECT_TRUE(runs[i].score.rmse) << runs[i].failure;
    EXPECT_FALSE(runs[i].kind.empty());
    EXPECT_EQ(runs[i].about, runs[i / 3 * 3].about);
    EXPECT_GT(runs[i].calibration.time, 0.0);
  }
}

TEST(RandomSuite, ResultsAreTheSameForAnyNumberOfJobs) { EXPECT_EQ(results(1), results(3)); }

}  // namespace
}  // namespace multipath_localization
