#include "evaluation/batch.hpp"

#include <cmath>

#include "evaluation/spoilt_drive.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "support/parallel.hpp"

namespace multipath_localization {

namespace {

Weighing weighing_of(const MeasurementReport& report) {
  const Innovation& told = report.innovation;
  const bool compared = told.covariance.trace() > 0.0 && std::isfinite(told.nis);
  return {report.stamp, report.measurement.index(), told.reason,
          compared ? std::optional(told.nis) : std::nullopt};
}

/// Of the fixes that were compared with what was expected, in their order.
std::vector<double> nis_of_fixes(const std::vector<Weighing>& weighings) {
  std::vector<double> all;
  for (const Weighing& weighing : weighings) {
    if (weighing.kind == kFixKind && weighing.nis) all.push_back(*weighing.nis);
  }
  return all;
}

void run_over(const Drive& drive, const Batch& batch, const EstimatorFactory& make,
              const ProgressReport& progress, RunRecord& run) {
  if (batch.faults) run.drive = spoilt(drive, *batch.faults, batch.fault_seed + run.seed - 1);
  const Drive& driven = batch.faults ? run.drive : drive;
  run.fates = drive.left_out;
  const auto count = [&run](const MeasurementReport& report) {
    run.fates[report.measurement.index()].count(report.innovation.reason);
    run.weighings.push_back(weighing_of(report));
  };
  run.epochs = run_drive(driven, make, batch.settings, progress, count);
  rate(driven, batch, run);
}

void run_over(const Scenario& scenario, const Batch& batch, const EstimatorFactory& make,
              const ProgressReport& progress, RunRecord& run) {
  const auto note = [&run](const MeasurementReport& report) { run.weighings.push_back(weighing_of(report)); };
  ClosedLoopRun result = run_scenario(scenario, run.seed, make, batch.settings, progress, note);
  run.course = result.course;
  run.epochs = std::move(result.epochs);
  run.drive = std::move(result.drive);
  rate(run.drive, batch, run);
}

}  // namespace

void rate(const Drive& drive, const Batch& batch, RunRecord& run) {
  if (drive.truth.empty()) return;
  const double from = drive.start() + batch.score_from;
  run.score = score(run.epochs, from);
  run.longest_off = longest_off(run.epochs, from, batch.off_from);
  run.longest_beyond_3_sigma = longest_beyond_3_sigma(run.epochs, from);
  run.way_to_alignment = way_to_alignment(run.epochs);
  run.fixes = score_fixes(drive, from);
  run.calibration = calibration(run.epochs, from, nis_of_fixes(run.weighings));
}

void make_run(const Stream& stream, const Batch& batch, const std::string& name,
              const std::string& parameters, const std::function<void(double)>& progress, RunRecord& run) {
  const double started = thread_cpu_time();
  try {
    const auto make = [&] { return make_estimator(name, YAML::Load(parameters), run.seed); };
    std::visit([&](const auto& s) { run_over(s, batch, make, progress, run); }, stream);
  } catch (const std::exception& error) {
    run.failure = error.what();
  }
  run.cpu = thread_cpu_time() - started;
  if (run.seed != batch.first_seed) {
    run.epochs = {};
    run.weighings = {};
    run.drive = {};
  }
}

std::vector<std::string> parameters_of(const Batch& batch, const Stream& stream,
                                       const ParameterOverrides& overrides) {
  const auto* scenario = std::get_if<Scenario>(&stream);
  std::vector<std::string> all;
  for (const EstimatorVariant& variant : batch.estimators) {
    const bool tuned = scenario != nullptr && scenario->localization.IsMap();
    const YAML::Node base = tuned ? scenario->localization[variant.name] : YAML::Node();
    const YAML::Node parameters = over(overrides.over(base, variant.name), variant);
    make_estimator(variant.name, parameters, 1);
    all.push_back(YAML::Dump(parameters));
  }
  return all;
}

std::vector<RunRecord> run_batch(const Batch& batch, const Stream& stream,
                                 const std::vector<std::string>& parameters,
                                 const std::function<void(std::size_t, double)>& progress) {
  std::vector<RunRecord> runs;
  for (const EstimatorVariant& variant : batch.estimators) {
    for (std::uint64_t seed = batch.first_seed; seed < batch.first_seed + batch.seeds; ++seed) {
      runs.emplace_back();
      runs.back().source = batch.source;
      runs.back().estimator = variant.label;
      runs.back().seed = seed;
    }
  }
  for_each_index(runs.size(), batch.jobs, [&](std::size_t i) {
    const auto report = [&](double fraction) {
      if (progress) progress(i, fraction);
    };
    const std::size_t variant = i / batch.seeds;
    make_run(stream, batch, batch.estimators[variant].name, parameters[variant], report, runs[i]);
    report(1.0);
  });
  return runs;
}

}  // namespace multipath_localization
