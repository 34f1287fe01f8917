#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "multipath_localization/evaluation/metrics.hpp"

namespace multipath_localization {

/// One run that came to its end.
struct RunRecord {
  std::string source;  ///< drive, bag or scenario, as named by the user
  std::string estimator;
  std::uint64_t seed = 1;
  Score score;
  double cpu = 0.0;  ///< processor time of the run [s]
};

/// The records as a JSON list, one object per run:
/// {"source","estimator","seed","epochs","mean_m","rmse_m","median_m","p95_m","max_m","heading_rmse_rad",
/// "rmse_shadow_m","rmse_open_m","nees_mean","cpu_s"}. A figure that does not apply is null.
std::string to_json(const std::vector<RunRecord>& records);

/// One line per estimator, in the order of their first records: means over its runs, and its worst run's
/// RMSE.
std::string to_table(const std::vector<RunRecord>& records);

}  // namespace multipath_localization
