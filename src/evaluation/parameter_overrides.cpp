#include "evaluation/parameter_overrides.hpp"

#include <algorithm>

#include "core/plain_yaml.hpp"
#include "evaluation/layered_maps.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

std::vector<std::string> split_path(const std::string& key) {
  std::vector<std::string> path(1);
  for (const char c : key) {
    if (c == '.' || c == '/') {
      path.emplace_back();
    } else {
      path.back() += c;
    }
  }
  return path;
}

YAML::Node parse_value(const std::string& text) {
  try {
    return plain(parse_yaml(text));
  } catch (const YAML::Exception& error) {
    throw ParameterError("'" + text + "' is not YAML: " + error.what());
  }
}

void assign(YAML::Node parameters, const std::vector<std::string>& path, const YAML::Node& value) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    YAML::Node inner = parameters[path[i]];
    if (!inner.IsMap()) inner = YAML::Node(YAML::NodeType::Map);
    parameters.reset(inner);
  }
  parameters[path.back()] = value;
}

}  // namespace

ParameterOverrides::ParameterOverrides(const std::vector<std::string>& assignments,
                                       const std::vector<std::string>& owners) {
  for (const std::string& text : assignments) {
    const std::size_t sign = text.find('=');
    Assignment assignment;
    assignment.path = split_path(text.substr(0, sign));
    const bool complete = std::none_of(assignment.path.begin(), assignment.path.end(),
                                       [](const std::string& part) { return part.empty(); });
    if (sign == std::string::npos || !complete) throw ParameterError("'" + text + "' is not key=value");
    assignment.value = text.substr(sign + 1);
    parse_value(assignment.value);
    const bool owned = std::find(owners.begin(), owners.end(), assignment.path.front()) != owners.end();
    if (owned && assignment.path.size() > 1) {
      assignment.owner = assignment.path.front();
      assignment.path.erase(assignment.path.begin());
    }
    assignments_.push_back(assignment);
  }
}

YAML::Node ParameterOverrides::over(const YAML::Node& parameters, const std::string& owner) const {
  YAML::Node result = laid_over(parameters, YAML::Node());
  for (const Assignment& assignment : assignments_) {
    if (assignment.owner.empty() || assignment.owner == owner) {
      assign(result, assignment.path, parse_value(assignment.value));
    }
  }
  return result;
}

YAML::Node ParameterOverrides::of(const std::string& owner) const {
  YAML::Node result(YAML::NodeType::Map);
  for (const Assignment& assignment : assignments_) {
    if (assignment.owner == owner) assign(result, assignment.path, parse_value(assignment.value));
  }
  return result;
}

std::vector<std::string> ParameterOverrides::owners() const {
  std::vector<std::string> named;
  for (const Assignment& assignment : assignments_) {
    if (!assignment.owner.empty()) named.push_back(assignment.owner);
  }
  return named;
}

}  // namespace multipath_localization
