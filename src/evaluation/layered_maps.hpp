#pragma once

#include <yaml-cpp/yaml.h>

namespace multipath_localization {

/// A copy of the map `base` with the map `upper` over it, map by map: what `upper` does not name stays, a
/// list or value that it names is replaced. What is no map counts as an empty one.
YAML::Node laid_over(const YAML::Node& base, const YAML::Node& upper);

}  // namespace multipath_localization
