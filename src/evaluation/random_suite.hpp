#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evaluation/batch.hpp"
#include "evaluation/random_drive.hpp"

namespace multipath_localization {

constexpr const char* kOracle = "oracle";  ///< what runs and tables call it

/// Runs every estimator of the batch and the oracle over the drive of each of the `seeds` (random_drive), in
/// their order, the oracle last; the estimators draw by the same seed, and are given the extras, the oracle
/// is not. `parameters` as from `parameters_of`. From several threads `progress` is told the index of the
/// seed and the fraction that is done, `ended` the runs with one seed. Results do not depend on `jobs`, but
/// for the processor time.
std::vector<RunRecord> run_random(const Batch& batch, const std::vector<std::uint64_t>& seeds,
                                  const RandomExtras& extras, const std::vector<std::string>& parameters,
                                  const std::function<void(std::size_t, double)>& progress,
                                  const std::function<void(const std::vector<RunRecord>&)>& ended = nullptr);

}  // namespace multipath_localization
