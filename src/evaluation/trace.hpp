#pragma once

#include <string>
#include <vector>

#include "evaluation/batch.hpp"

namespace multipath_localization {

/// The runs of the first seed that ended, as JSON for scripts/plot_evaluation and scripts/report: truth,
/// fixes and odometry of the stream (of the first run, in a scenario), how far the fixes were off, and of
/// each run its estimates, states, errors and declared covariances over time [s, m, rad], errors of the
/// heading [deg], its measurements as they were weighed, its figures as `json_of_figures` gives them and,
/// where it went over another drive than the first run, that drive.
std::string to_trace(const std::string& title, const Stream& stream, const std::vector<RunRecord>& runs);

}  // namespace multipath_localization
