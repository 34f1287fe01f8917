#pragma once

#include <string>
#include <vector>

#include "evaluation/batch.hpp"

namespace multipath_localization {

/// How honest each estimator was over all its runs, one column for each, as text.
std::string describe_calibration(const std::vector<RunRecord>& runs);

}  // namespace multipath_localization
