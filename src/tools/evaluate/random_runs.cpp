#include "tools/evaluate/random_runs.hpp"

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <optional>

#include "evaluation/drive_files.hpp"
#include "evaluation/progress.hpp"
#include "evaluation/random_suite.hpp"
#include "evaluation/results_file.hpp"

namespace multipath_localization {

namespace {

/// What runs over random robots are made of.
Evaluation evaluation_of(const Options& options) {
  Evaluation evaluation;
  evaluation.suite = options.suite;
  for (const NamedExtra& extra : kExtras) {
    if (options.extras.*extra.given) evaluation.inputs.emplace_back(extra.name);
  }
  for (const EstimatorVariant& variant : options.batch.estimators) {
    evaluation.estimators.push_back(variant.label + "=" + variant.name + variant.parameters);
  }
  evaluation.parameters = options.assignments;
  evaluation.score_from = options.batch.score_from;
  return evaluation;
}

}  // namespace

std::vector<RunRecord> make_random_runs(const Options& options, const Batch& batch,
                                        const std::vector<std::string>& parameters) {
  std::optional<ResultsFile> results;
  if (!options.results_files.empty()) results.emplace(options.results_files.front(), evaluation_of(options));
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t seed = batch.first_seed; seed < batch.first_seed + batch.seeds; ++seed) {
    if (!results || !results->holds(seed)) seeds.push_back(seed);
  }
  ProgressBar bar(seeds.size(), isatty(STDERR_FILENO) != 0);
  std::vector<RunRecord> runs = run_random(
      batch, seeds, options.extras, parameters, [&](std::size_t i, double part) { bar.update(i, part); },
      [&](const std::vector<RunRecord>& ended) {
        if (results) results->add(ended);
      });
  if (results) runs.insert(runs.end(), results->runs().begin(), results->runs().end());
  return runs;
}

void write_random_drives(const Options& options) {
  const std::uint64_t first = options.batch.first_seed;
  for (std::uint64_t seed = first; seed < first + options.batch.seeds; ++seed) {
    const RandomDrive made = random_drive(seed, options.extras);
    const std::string directory = (std::filesystem::path(options.write_directory) / made.drive.name).string();
    write_drive(made.drive, directory);
    std::cout << directory << ": " << describe(made.robot) << "\n";
  }
}

}  // namespace multipath_localization
