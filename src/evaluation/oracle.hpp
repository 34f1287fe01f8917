#pragma once

#include <vector>

#include "evaluation/metrics.hpp"
#include "evaluation/random_drive.hpp"

namespace multipath_localization {

/// The bound that no estimator passes: an extended Kalman filter that is told the heading at the start, for
/// each fix what is wrong with it, for receiver and odometry every standard deviation and time constant they
/// were drawn with, and whose wheels have no faults. It carries pose, the constants of odometry, and of the
/// fixes a constant, a slow and a biased part. Optimal but for the linearisation; one epoch per truth sample,
/// the first ones without estimate until there was a fix.
std::vector<Epoch> run_oracle(const RandomDrive& drive);

}  // namespace multipath_localization
