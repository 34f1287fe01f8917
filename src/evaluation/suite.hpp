#pragma once

#include <string>
#include <vector>

#include "evaluation/scenario.hpp"

namespace multipath_localization {

/// Reads a suite of scenarios that differ in little: `base` holds what a scenario file holds, and each entry
/// of `rows`, by its name, what is different there, laid over it map by map. Scenarios in the order of the
/// file. Throws ParameterError when it cannot be read, has no rows or holds what nobody reads.
std::vector<Scenario> load_suite(const std::string& file);

}  // namespace multipath_localization
