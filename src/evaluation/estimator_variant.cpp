#include "evaluation/estimator_variant.hpp"

#include <set>

#include "core/plain_yaml.hpp"
#include "evaluation/layered_maps.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

/// The parts between commas that no bracket encloses.
std::vector<std::string> split_outside_brackets(const std::string& list) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : list) {
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (c == ',' && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

EstimatorVariant parse_variant(const std::string& text) {
  const std::size_t brace = text.find('{');
  const std::string head = text.substr(0, brace);
  const std::size_t sign = head.find('=');
  EstimatorVariant variant;
  variant.label = sign == std::string::npos ? text : head.substr(0, sign);
  variant.name = sign == std::string::npos ? head : head.substr(sign + 1);
  if (brace != std::string::npos) variant.parameters = text.substr(brace);
  if (variant.label.empty() || variant.name.empty()) {
    throw ParameterError("'" + text + "' is not [LABEL=]NAME[{KEY: VALUE, ...}]");
  }
  return variant;
}

void refuse_what_is_no_map(const EstimatorVariant& variant) {
  try {
    if (variant.parameters.empty()) return;
    const YAML::Node all = parse_yaml("[" + variant.parameters + "]");  // so that nothing follows unread
    if (all.size() == 1 && all[0].IsMap()) return;
  } catch (const YAML::Exception&) {
  }
  throw ParameterError("'" + variant.parameters + "' is not {KEY: VALUE, ...}");
}

}  // namespace

std::vector<EstimatorVariant> parse_variants(const std::string& list) {
  std::vector<EstimatorVariant> variants;
  std::set<std::string> labels;
  for (const std::string& text : split_outside_brackets(list)) {
    variants.push_back(parse_variant(text));
    refuse_what_is_no_map(variants.back());
    if (!labels.insert(variants.back().label).second) {
      throw ParameterError("two estimators are called '" + variants.back().label + "'");
    }
  }
  return variants;
}

YAML::Node over(const YAML::Node& parameters, const EstimatorVariant& variant) {
  return laid_over(parameters, variant.parameters.empty() ? YAML::Node() : parse_yaml(variant.parameters));
}

}  // namespace multipath_localization
