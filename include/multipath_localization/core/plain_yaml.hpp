#pragma once

#include <yaml-cpp/yaml.h>

namespace multipath_localization {

/// A copy in which nothing is shared: what an alias stands for is there as often as it is named, and no
/// change shows in two places. Throws ParameterError where it is nested over 64 deep, in itself for one, or
/// holds over 50 000 values and keys: a few lines of aliases of aliases stand for millions.
YAML::Node plain(const YAML::Node& source);

}  // namespace multipath_localization
