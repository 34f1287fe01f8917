#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace multipath_localization {

/// Parameters set on a command line as `key=value`, where `key` goes into nested parameters by dots or
/// slashes and `value` is YAML. A key that begins with the name of an owner, `owner.key=value`, is for that
/// owner alone.
class ParameterOverrides {
 public:
  /// Throws ParameterError on what is not of that form.
  ParameterOverrides(const std::vector<std::string>& assignments, const std::vector<std::string>& owners);

  /// A copy of `parameters` (a map or null) with all that is meant for `owner` over it.
  [[nodiscard]] YAML::Node over(const YAML::Node& parameters, const std::string& owner) const;

  /// The same with nothing but what names the owner.
  [[nodiscard]] YAML::Node of(const std::string& owner) const;

  /// Every owner that is named.
  [[nodiscard]] std::vector<std::string> owners() const;

 private:
  struct Assignment {
    std::string owner;  ///< empty for all
    std::vector<std::string> path;
    std::string value;
  };

  std::vector<Assignment> assignments_;
};

}  // namespace multipath_localization
