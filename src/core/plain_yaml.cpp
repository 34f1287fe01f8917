#include "multipath_localization/core/plain_yaml.hpp"

#include <cstddef>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

constexpr int kDeepest = 64;
constexpr std::size_t kMost = 50000;

/// Adds to `counted` what a copy would hold. To count is quick, to copy is not.
void count(const YAML::Node& source, int depth, std::size_t& counted) {
  if (depth > kDeepest) throw ParameterError("YAML is nested over 64 deep, or within itself");
  if (++counted > kMost) throw ParameterError("YAML holds over 50000 values, those of aliases counted");
  if (source.IsMap()) {
    for (const auto& entry : source) {
      count(entry.first, depth + 1, counted);
      count(entry.second, depth + 1, counted);
    }
  } else if (source.IsSequence()) {
    for (const YAML::Node& item : source) count(item, depth + 1, counted);
  }
}

YAML::Node copy(const YAML::Node& source) {
  if (!source.IsMap() && !source.IsSequence()) return YAML::Clone(source);
  YAML::Node result(source.Type());
  if (source.IsMap()) {
    for (const auto& entry : source) result.force_insert(copy(entry.first), copy(entry.second));
  } else {
    for (const YAML::Node& item : source) result.push_back(copy(item));
  }
  return result;
}

}  // namespace

YAML::Node plain(const YAML::Node& source) {
  std::size_t counted = 0;
  count(source, 0, counted);
  return copy(source);
}

}  // namespace multipath_localization
