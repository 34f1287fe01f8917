#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/batch.hpp"

namespace multipath_localization {

/// How an estimator did over many drives. Errors below a millimetre count as one. Geometric means are over
/// the drives with a score, shares of all drives it was run on, without a score counts as behind.
struct Standing {
  std::string estimator;
  std::size_t drives = 0;
  std::size_t scored = 0;
  std::optional<double> rmse;           ///< geometric mean [m]
  std::optional<double> to_best;        ///< of the RMSE over that of the best other: geometric mean
  std::optional<double> to_oracle;      ///< of the RMSE over that of the oracle: geometric mean
  std::optional<double> behind;         ///< share of drives behind the best other by over 10 %
  std::optional<double> overconfident;  ///< share with a mean NEES over 6
  std::optional<double> beyond_5;       ///< share that was outside its own 3 sigma for over 5 s on end
  std::optional<double> beyond_30;      ///< for over 30 s
  double cpu = 0.0;                     ///< all drives together [s]
};

/// A drive and how one estimator did on it beside the best other.
struct Comparison {
  const RunRecord* run = nullptr;
  std::string best;        ///< the best other
  double best_rmse = 0.0;  ///< [m]
  double ratio = 0.0;
};

/// The standing of the fixes as they are and of each estimator over the drives (source and seed) of the runs,
/// of one kind or, where that is empty, of all. The best other is the best of the fixes as they are,
/// `gated_ekf` and `two_stage_ekf`, but for the estimator itself.
std::vector<Standing> standings(const std::vector<RunRecord>& runs, const std::string& kind);

/// The runs of the first estimator, the worst beside the best other first.
std::vector<Comparison> worst_first(const std::vector<RunRecord>& runs);

/// The standings of all drives and of each kind, and the ten worst drives of the first estimator, as text.
std::string describe_standings(const std::vector<RunRecord>& runs);

}  // namespace multipath_localization
