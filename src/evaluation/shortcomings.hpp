#pragma once

#include <string>
#include <vector>

#include "evaluation/batch.hpp"

namespace multipath_localization {

/// What is to be wished for of the estimator that was run first, a sentence each, stream by stream: that
/// another one is better (by its mean RMSE over the seeds, by over 10 % and over 0.05 m), that a run did not
/// end, that in one its error stayed outside its own 3 sigma ellipse for over 5 s.
std::vector<std::string> shortcomings(const std::vector<RunRecord>& runs);

}  // namespace multipath_localization
