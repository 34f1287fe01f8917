#include <gtest/gtest.h>

#include <map>

#include "evaluation/batch.hpp"
#include "evaluation/report.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"

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
  batch.estimators = parse_variants(estimator_names().front());
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

TEST(RunBatch, KeepsStatesAndWeighingsOfTheFirstSeedAlone) {
  const std::vector<RunRecord> runs = made(batch_of(2), short_street(), 1);
  ASSERT_FALSE(runs[0].weighings.empty());
  EXPECT_TRUE(runs[1].weighings.empty());
  EXPECT_GT(runs[0].weighings.back().nis.value_or(0.0), 0.0);
  EXPECT_NE(runs[0].epochs.back().state, Trust::kNotReady);

  const std::vector<RunRecord> replayed = made(batch_of(1), runs[0].drive, 1);
  EXPECT_EQ(replayed[0].weighings.size(), runs[0].weighings.size());
  EXPECT_EQ(replayed[0].epochs.back().state, runs[0].epochs.back().state);
}

TEST(RunBatch, SeedsDiffer) {
  const std::vector<RunRecord> runs = made(batch_of(2), short_street(), 1);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].seed, 1u);
  EXPECT_EQ(runs[1].seed, 2u);
  EXPECT_NE(*runs[0].score.rmse, *runs[1].score.rmse);
}

/// RMSE of each variant on the paddy with its wheels slipping by `wheel_noise` [m/s].
std::map<std::string, Score> scores_on_paddy(const std::string& variants, double wheel_noise) {
  Scenario scenario = load_scenario(std::string(CONFIG_DIR) + "/scenarios/paddy.yaml");
  scenario.simulator.robot.wheel_noise = wheel_noise;
  Batch batch = batch_of(1);
  batch.estimators = parse_variants(variants);
  const ParameterOverrides overrides({"wheel_noise=" + std::to_string(wheel_noise)}, {});
  std::map<std::string, Score> scores;
  for (const RunRecord& run :
       run_batch(batch, scenario, parameters_of(batch, scenario, overrides), nullptr)) {
    EXPECT_EQ(run.failure, "");
    scores[run.estimator] = run.score;
  }
  return scores;
}

/// Section 4.1 of [KAM] as printed, with its deviation for small and middle wheel noise, and repaired.
TEST(RunBatch, RunsVariantsOfOneEstimatorSideBySide) {
  const std::string variants =
      "repaired=dual_antenna_ekf,printed=dual_antenna_ekf{heading_jacobian: false, wrap_innovation: false, "
      "subtract_mean: false, gate: .inf}";
  constexpr double kDegree = 3.14159265358979 / 180.0;
  for (const auto& [wheel_noise, slip_between_pairs] : {std::pair(0.1, 1.5), std::pair(0.3, 2.5)}) {
    std::map<std::string, Score> scores = scores_on_paddy(variants, wheel_noise);
    EXPECT_GT(*scores["printed"].heading_rmse, 30.0 * kDegree);
    EXPECT_GT(*scores["printed"].rmse, 0.15);
    EXPECT_LT(*scores["repaired"].heading_rmse, slip_between_pairs * kDegree);
    EXPECT_LT(*scores["repaired"].rmse, 0.01);
  }
  std::map<std::string, Score> large = scores_on_paddy(variants, 1.0);
  EXPECT_LT(*large["printed"].heading_rmse, 15.0 * kDegree);
  EXPECT_LT(*large["repaired"].rmse, 0.03);
}

/// Means over seeds 1..4 of the simulation of [NIS] [m].
struct InShadow {
  double rmse = 0.0;
  double fix_rmse = 0.0;
  double worst_miss = 0.0;  ///< of a waypoint
};

/// Of config/working, with `more` set otherwise.
InShadow first_paper(const std::map<std::string, std::string>& more) {
  YAML::Node settings = YAML::LoadFile(std::string(CONFIG_DIR) + "/working/nishida_particle_filter.yaml");
  for (const auto& [key, value] : more) settings[key] = value;
  settings.SetStyle(YAML::EmitterStyle::Flow);
  Batch batch = batch_of(4);
  batch.estimators = parse_variants("nishida_particle_filter" + YAML::Dump(settings));
  InShadow mean;
  for (const RunRecord& run :
       made(batch, load_scenario(std::string(CONFIG_DIR) + "/scenarios/nishida.yaml"), 1)) {
    EXPECT_EQ(run.failure, "");
    mean.rmse += *run.score.rmse_shadow / 4.0;
    mean.fix_rmse += *run.fixes.rmse_shadow / 4.0;
    mean.worst_miss += *run.course.worst_miss / 4.0;
  }
  return mean;
}

TEST(RunBatch, FirstPaperWorksByItsThreeDeparturesAndByNoneLess) {
  constexpr double kCrossingWidth = 2.0;  // [m] of the scenario
  const InShadow working = first_paper({});
  EXPECT_LT(working.rmse, 0.25 * working.fix_rmse);
  EXPECT_LT(working.worst_miss, kCrossingWidth);
  const InShadow blind = first_paper({{"sky", "fixed"}});
  EXPECT_GT(blind.rmse, 0.5 * blind.fix_rmse);
  EXPECT_GT(first_paper({{"shadow_place", "ring"}}).rmse, 1.3 * working.rmse);
  EXPECT_GT(first_paper({{"bias_motion", "rate"}}).rmse, 1.3 * working.rmse);
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

TEST(ParametersOf, AreTheScenariosThenTheOverridesThenTheVariants) {
  Scenario scenario = short_street();
  scenario.localization = YAML::Load("{gated_ekf: {gate: 1, reopen_after: 1, fix_sigma_cap: 1}}");
  Batch batch = batch_of(1);
  batch.estimators = parse_variants("gated_ekf,mine=gated_ekf{fix_sigma_cap: 3, odometry: {yaw: 0.5}}");
  const ParameterOverrides overrides({"gated_ekf.reopen_after=2", "fix_sigma_cap=2"}, {"gated_ekf"});
  const std::vector<std::string> all = parameters_of(batch, scenario, overrides);
  ASSERT_EQ(all.size(), 2u);
  const YAML::Node plain = YAML::Load(all[0]);
  EXPECT_EQ(plain["gate"].as<int>(), 1);
  EXPECT_EQ(plain["reopen_after"].as<int>(), 2);
  EXPECT_EQ(plain["fix_sigma_cap"].as<int>(), 2);
  const YAML::Node mine = YAML::Load(all[1]);
  EXPECT_EQ(mine["fix_sigma_cap"].as<int>(), 3);
  EXPECT_EQ(mine["odometry"]["yaw"].as<double>(), 0.5);
}

TEST(ParametersOf, TakeTheScenariosAndThenTheOverrides) {
  Scenario scenario = short_street();
  scenario.localization = YAML::Load("{" + estimator_names().front() + ": {no_such_key: 1}}");
  EXPECT_THROW(parameters_of(batch_of(1), scenario, ParameterOverrides({}, {})), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
