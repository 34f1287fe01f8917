#include <gtest/gtest.h>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/evaluation/batch.hpp"
#include "multipath_localization/evaluation/report.hpp"

namespace multipath_localization {
namespace {

Scenario short_street() {
  Scenario scenario = load_scenario(std::string(CONFIG_DIR) + "/scenarios/street.yaml");
  scenario.duration = 10.0;
  return scenario;
}

Batch batch_of(std::uint64_t seeds) {
  Batch batch;
  batch.source = "here";
  batch.estimators = {estimator_names().front()};
  batch.seeds = seeds;
  return batch;
}

std::vector<RunRecord> made(Batch batch, const Stream& stream, std::size_t jobs) {
  batch.jobs = jobs;
  return run_batch(batch, stream, parameters_of(batch, stream, ParameterOverrides({}, {})), nullptr);
}

/// The report with what may differ, the processor time, taken out.
std::string json_of(std::vector<RunRecord> runs) {
  for (RunRecord& run : runs) run.cpu = 0.0;
  return to_json(runs);
}

TEST(RunBatch, NumberOfJobsChangesNoByte) {
  const Stream scenario = short_street();
  const std::vector<RunRecord> alone = made(batch_of(3), scenario, 1);
  EXPECT_EQ(json_of(alone), json_of(made(batch_of(3), scenario, 2)));

  const Stream drive = alone.front().drive;
  EXPECT_EQ(json_of(made(batch_of(3), drive, 1)), json_of(made(batch_of(3), drive, 2)));
}

TEST(RunBatch, SeedsDiffer) {
  const std::vector<RunRecord> runs = made(batch_of(2), short_street(), 1);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].seed, 1u);
  EXPECT_EQ(runs[1].seed, 2u);
  EXPECT_NE(*runs[0].score.rmse, *runs[1].score.rmse);
}

TEST(RunBatch, SaysWhyARunDidNotEnd) {
  Drive drive = made(batch_of(1), short_street(), 1).front().drive;
  drive.truth.clear();
  Batch batch = batch_of(1);
  batch.settings.known_start = true;
  const std::vector<RunRecord> runs = made(batch, drive, 1);
  EXPECT_NE(runs.front().failure.find("start"), std::string::npos);
  EXPECT_EQ(to_json(runs), "[\n]\n");
}

TEST(ParametersOf, RefuseWhatTheEstimatorDoesNotKnow) {
  const Batch batch = batch_of(1);
  try {
    parameters_of(batch, Drive(), ParameterOverrides({"no_such_key=1"}, {}));
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("no_such_key"), std::string::npos);
  }
}

TEST(ParametersOf, TakeTheScenariosAndThenTheOverrides) {
  Scenario scenario = short_street();
  scenario.localization = YAML::Load("{" + estimator_names().front() + ": {no_such_key: 1}}");
  EXPECT_THROW(parameters_of(batch_of(1), scenario, ParameterOverrides({}, {})), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
