#include "evaluation/layered_maps.hpp"

#include <string>
#include <utility>
#include <vector>

#include "core/plain_yaml.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

YAML::Node laid_over(const YAML::Node& base, const YAML::Node& upper) {
  YAML::Node result = base && base.IsMap() ? plain(base) : YAML::Node(YAML::NodeType::Map);
  std::vector<std::pair<YAML::Node, YAML::Node>> to_do;
  if (upper && upper.IsMap()) to_do.emplace_back(result, plain(upper));
  while (!to_do.empty()) {
    auto [below, above] = to_do.back();
    to_do.pop_back();
    for (const auto& entry : above) {
      const std::string& key = text_of_key(entry.first, "a map that is laid over another");
      if (entry.second.IsMap() && below[key].IsMap()) {
        to_do.emplace_back(below[key], entry.second);
      } else {
        below[key] = entry.second;
      }
    }
  }
  return result;
}

}  // namespace multipath_localization
