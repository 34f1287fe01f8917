#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "multipath_localization/estimators/estimator.hpp"

namespace multipath_localization {

/// All names `make_estimator` knows; the first is the default.
const std::vector<std::string>& estimator_names();

/// Makes an estimator by name with the entries of `parameters` (a YAML map or null) over its defaults.
/// Throws ParameterError on an unknown name or an unusable parameter.
std::unique_ptr<Estimator> make_estimator(const std::string& name, const YAML::Node& parameters,
                                          std::uint64_t seed);

/// The estimator's parameters with their defaults as commented YAML: the content of config/<name>.yaml.
std::string describe_estimator(const std::string& name);

}  // namespace multipath_localization
