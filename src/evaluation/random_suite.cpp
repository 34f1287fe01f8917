#include "evaluation/random_suite.hpp"

#include <algorithm>
#include <iterator>

#include "evaluation/json.hpp"
#include "evaluation/oracle.hpp"
#include "support/parallel.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

double share_in_shadow(const std::vector<TruthSample>& truth) {
  const auto shadow = std::count_if(truth.begin(), truth.end(),
                                    [](const TruthSample& sample) { return sample.shadow.value_or(false); });
  return static_cast<double>(shadow) / static_cast<double>(truth.size());
}

std::vector<std::pair<std::string, std::string>> traits_of(const RandomDrive& drive) {
  const RandomRobot& robot = drive.robot;
  return {{"declaration", quoted(std::string(to_string(robot.receiver.declaration)))},
          {"street", quoted(std::string(to_string(robot.way.street)))},
          {"yaw_source", quoted(std::string(to_string(robot.odometry.yaw)))},
          {"speed_mps", plain_text(robot.way.speed)},
          {"fix_rate_hz", plain_text(1e3 / robot.receiver.period_ms)},
          {"odometry_rate_hz", plain_text(1e3 / robot.odometry.period_ms)},
          {"open_sky_sigma_m", plain_text(robot.receiver.levels.front().sigma())},
          {"shadow_share", plain_text(share_in_shadow(drive.drive.truth))},
          {"outlier_share", plain_text(robot.receiver.outlier_share)},
          {"wheel_faults", std::to_string(robot.odometry.faults.size())}};
}

void run_oracle_over(const RandomDrive& drive, const Batch& batch, RunRecord& run) {
  const double started = thread_cpu_time();
  run.epochs = run_oracle(drive);
  rate(drive.drive, batch, run);
  run.cpu = thread_cpu_time() - started;
}

/// What holds for all runs over a drive.
RunRecord run_over(const RandomDrive& made, const Batch& batch, std::uint64_t seed) {
  RunRecord run;
  run.source = batch.source;
  run.seed = seed;
  run.kind = to_string(made.robot.receiver.kind);
  run.about = describe(made.robot);
  run.traits = traits_of(made);
  return run;
}

/// Runs one of the estimators, or names the oracle, which has run, behind them.
void run_variant(const Stream& stream, const Batch& batch, const std::vector<std::string>& parameters,
                 std::size_t variant, RunRecord& run) {
  if (variant == batch.estimators.size()) {
    run.estimator = kOracle;
  } else {
    run.estimator = batch.estimators[variant].label;
    make_run(stream, batch, batch.estimators[variant].name, parameters[variant], nullptr, run);
  }
  run.epochs = {};
  run.weighings = {};
}

std::vector<RunRecord> run_seed(const Batch& batch, std::uint64_t seed, const RandomExtras& extras,
                                const std::vector<std::string>& parameters,
                                const std::function<void(double)>& progress) {
  const std::size_t all = batch.estimators.size() + 1;
  RandomDrive made = random_drive(seed, extras);
  std::vector<RunRecord> runs(all, run_over(made, batch, seed));
  run_oracle_over(made, batch, runs.back());
  const Stream stream = std::move(made.drive);
  for (std::size_t variant = 0; variant < all; ++variant) {
    run_variant(stream, batch, parameters, variant, runs[variant]);
    progress(static_cast<double>(variant + 1) / static_cast<double>(all));
  }
  return runs;
}

}  // namespace

std::vector<RunRecord> run_random(const Batch& batch, const std::vector<std::uint64_t>& seeds,
                                  const RandomExtras& extras, const std::vector<std::string>& parameters,
                                  const std::function<void(std::size_t, double)>& progress,
                                  const std::function<void(const std::vector<RunRecord>&)>& ended) {
  std::vector<std::vector<RunRecord>> by_seed(seeds.size());
  for_each_index(seeds.size(), batch.jobs, [&](std::size_t i) {
    by_seed[i] = run_seed(batch, seeds[i], extras, parameters, [&](double part) {
      if (progress) progress(i, part);
    });
    if (ended) ended(by_seed[i]);
  });
  std::vector<RunRecord> all;
  for (std::vector<RunRecord>& runs : by_seed) std::move(runs.begin(), runs.end(), std::back_inserter(all));
  return all;
}

}  // namespace multipath_localization
