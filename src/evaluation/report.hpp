#pragma once

#include <string>
#include <vector>

#include "evaluation/batch.hpp"

namespace multipath_localization {

/// The figures of a run as one object of JSON:
/// {"source","estimator","seed","epochs","mean_m","rmse_m","median_m","p95_m","max_m","heading_rmse_rad",
/// "rmse_shadow_m","rmse_open_m","longest_off_s","longest_beyond_3_sigma_s","nees_mean","cpu_s","fix_rmse_m",
/// "fix_median_m","fix_p95_m","fix_max_m","fix_rmse_shadow_m","fix_rmse_open_m"}, the last six of the fixes
/// as they are. A figure that does not apply is null.
std::string json_of_figures(const RunRecord& run);

/// The runs that ended as a JSON list, one object per run.
std::string to_json(const std::vector<RunRecord>& runs);

/// The runs that ended as a table: per stream one line for the fixes as they are and one per estimator, in
/// the order of their first runs; the runs of a stream stand together. Figures are means over the runs, in
/// metres where nothing else is said; of waypoints passed the least and of their misses the most; last the
/// worst run. Columns that apply to no line are left out.
std::string to_table(const std::vector<RunRecord>& runs);

/// For each estimator that could not use more than a tenth of a kind of measurements, in its first run over a
/// recording, a line that says why: "gated_ekf: fixes: 3 of 240 used; old stamp 237 (...)".
std::string losses(const std::vector<RunRecord>& runs);

}  // namespace multipath_localization
