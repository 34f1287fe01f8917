#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evaluation/batch.hpp"
#include "evaluation/random_drive.hpp"

namespace multipath_localization {

constexpr const char* kOracle = "oracle";  ///< what runs and tables call it

/// Runs every estimator of the batch and the oracle over the drive of each seed (random_drive), in the order
/// of estimators, the oracle last, and then seeds; the estimators draw by the same seed, and are given the
/// extras, the oracle is not. `parameters` as from
/// `parameters_of`. `progress` is told the index of the seed and the fraction that is done, from several
/// threads. Results do not depend on `jobs`, but for the processor time.
std::vector<RunRecord> run_random(const Batch& batch, const RandomExtras& extras,
                                  const std::vector<std::string>& parameters,
                                  const std::function<void(std::size_t, double)>& progress);

}  // namespace multipath_localization
