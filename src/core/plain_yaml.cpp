#include "multipath_localization/core/plain_yaml.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

constexpr int kDeepest = 64;
constexpr std::size_t kMost = 50000;

bool holds_others(const YAML::Node& node) { return node.IsMap() || node.IsSequence(); }

/// Counts what a copy would hold, which is quick where to copy is not.
class Census {
 public:
  void take(const YAML::Node& source) {
    add(source, 0);
    while (!to_do_.empty()) {
      const auto [node, depth] = to_do_.back();
      to_do_.pop_back();
      for (const auto& item : node) {
        if (node.IsSequence()) {
          add(item, depth + 1);
        } else {
          add(item.first, depth + 1);
          add(item.second, depth + 1);
        }
      }
    }
  }

 private:
  void add(const YAML::Node& node, int depth) {
    if (depth > kDeepest) throw ParameterError("YAML is nested over 64 deep, or within itself");
    if (++counted_ > kMost) throw ParameterError("YAML holds over 50000 values, those of aliases counted");
    if (holds_others(node)) to_do_.emplace_back(node, depth);
  }

  std::vector<std::pair<YAML::Node, int>> to_do_;
  std::size_t counted_ = 0;
};

/// Copies what a census has found to be little enough.
class Copier {
 public:
  YAML::Node copy(const YAML::Node& source) {
    const YAML::Node result = begun(source);
    while (!to_do_.empty()) {
      auto [from, to] = to_do_.back();
      to_do_.pop_back();
      for (const auto& item : from) {
        if (from.IsSequence()) {
          to.push_back(begun(item));
        } else {
          to.force_insert(YAML::Clone(item.first), begun(item.second));
        }
      }
    }
    return result;
  }

 private:
  /// Maps and lists are empty as yet.
  YAML::Node begun(const YAML::Node& source) {
    if (!holds_others(source)) return YAML::Clone(source);
    const YAML::Node copy(source.Type());
    to_do_.emplace_back(source, copy);
    return copy;
  }

  std::vector<std::pair<YAML::Node, YAML::Node>> to_do_;
};

}  // namespace

YAML::Node plain(const YAML::Node& source) {
  Census().take(source);
  return Copier().copy(source);
}

}  // namespace multipath_localization
