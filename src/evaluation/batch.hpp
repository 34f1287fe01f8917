#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "evaluation/calibration.hpp"
#include "evaluation/closed_loop.hpp"
#include "evaluation/estimator_variant.hpp"
#include "evaluation/parameter_overrides.hpp"
#include "simulation/faults.hpp"

namespace multipath_localization {

/// What estimators are run over: a recording, or a scenario that each run drives through itself.
using Stream = std::variant<Drive, Scenario>;

/// Every estimator with every seed over one stream.
struct Batch {
  std::string source;  ///< what the runs call the stream
  std::vector<EstimatorVariant> estimators;
  std::uint64_t first_seed = 1;
  std::uint64_t seeds = 1;  ///< how many, from the first one on
  std::size_t jobs = 1;     ///< runs at a time
  double score_from = 0.0;  ///< after the start of the stream [s]
  double off_from = 2.0;    ///< error from which an estimate counts as off [m]
  RunSettings settings;
  std::optional<FaultParameters> faults;  ///< of a recording; a scenario has its own
  std::uint64_t fault_seed = 1;           ///< of the first run, counted on with the seeds
};

/// A measurement as an estimator weighed it.
struct Weighing {
  double stamp = 0.0;
  std::size_t kind = 0;  ///< index within Measurement
  Reason reason = Reason::kUnused;
  std::optional<double> nis;  ///< normalised innovation squared, where it was compared with what was expected
};

/// One run and what came of it.
struct RunRecord {
  std::string source;     ///< drive, bag or scenario, as named by the user
  std::string estimator;  ///< label of the variant
  std::uint64_t seed = 1;
  std::string failure;  ///< why it did not end, and then nothing below counts; empty when it did
  Score score;
  Score fixes;                                   ///< of the fixes as they came
  std::optional<double> longest_off;             ///< the estimate was off on end [s]
  std::optional<double> longest_beyond_3_sigma;  ///< by its own covariance, on end [s]
  std::optional<double> way_to_alignment;        ///< driven before the estimate was aligned [m]
  Calibration calibration;
  Course course;  ///< scenarios only
  /// What became of the measurements, by kind, those that the reader left out among them; recordings only.
  std::array<ReasonTally, std::variant_size_v<Measurement>> fates;
  double cpu = 0.0;  ///< processor time of the thread, the simulator's included [s]

  std::string kind;   ///< of the drive, by which suites sum up; empty: there are no kinds
  std::string about;  ///< the drive in one line
  std::vector<std::pair<std::string, std::string>> traits;  ///< of the drive: name and value, as JSON

  std::vector<Epoch> epochs;        ///< of the first seed only, to be drawn
  std::vector<Weighing> weighings;  ///< of the first seed only, in the order of their use
  Drive drive;                      ///< of the first seed of a scenario, or of a recording with faults, only
};

/// Parameters of each estimator of the batch as YAML text: those of the scenario, over them the `overrides`
/// for its name, over these the variant's own. Throws ParameterError on an unknown estimator or an unusable
/// parameter.
std::vector<std::string> parameters_of(const Batch& batch, const Stream& stream,
                                       const ParameterOverrides& overrides);

/// Scores a run by its epochs over a drive.
void rate(const Drive& drive, const Batch& batch, RunRecord& run);

/// Makes the run of an estimator over a stream with the seed that is in `run`, and scores it.
void make_run(const Stream& stream, const Batch& batch, const std::string& name,
              const std::string& parameters, const std::function<void(double)>& progress, RunRecord& run);

/// Makes all runs, in the order of the estimators and then the seeds; `parameters` as from `parameters_of`.
/// `progress` is told the run and the fraction of it that is done, from several threads. Results do not
/// depend on `jobs`, but for the processor time.
std::vector<RunRecord> run_batch(const Batch& batch, const Stream& stream,
                                 const std::vector<std::string>& parameters,
                                 const std::function<void(std::size_t, double)>& progress);

}  // namespace multipath_localization
