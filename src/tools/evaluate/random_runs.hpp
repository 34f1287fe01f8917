#pragma once

#include <string>
#include <vector>

#include "tools/evaluate/command_line.hpp"

namespace multipath_localization {

/// Runs the suite of random robots with the parameters of each estimator; keeps the runs in the file of
/// results, where there is one, and takes from it those that it holds. Throws ResultsError.
std::vector<RunRecord> make_random_runs(const Options& options, const Batch& batch,
                                        const std::vector<std::string>& parameters);

/// Writes the drives of the random robots as recordings and prints where, with each robot in a line. Throws
/// DriveError.
void write_random_drives(const Options& options);

}  // namespace multipath_localization
