#pragma once

#include <string>
#include <vector>

#include "evaluation/batch.hpp"

namespace multipath_localization {

/// The runs of seed 1 that ended, as JSON for scripts/plot_evaluation: truth and fixes of the stream (of the
/// first run, in a scenario), how far the fixes were off, and of each run its estimates, errors and declared
/// standard deviations over time [s, m], and errors of the heading [deg].
std::string to_trace(const std::string& title, const Stream& stream, const std::vector<RunRecord>& runs);

}  // namespace multipath_localization
