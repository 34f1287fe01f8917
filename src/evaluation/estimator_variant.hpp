#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace multipath_localization {

/// An estimator with parameters of its own, to compare it with itself.
struct EstimatorVariant {
  std::string label;       ///< what runs, tables and plots call it
  std::string name;        ///< as make_estimator knows it
  std::string parameters;  ///< a map in YAML, over all others; empty for none
};

/// Variants from a list `NAME,NAME{KEY: VALUE, ...},LABEL=NAME{KEY: VALUE, ...}`. Without a label the text
/// itself is it. Throws ParameterError on what is not of that form and on a label given twice; whether there
/// is an estimator of that name is not looked at.
std::vector<EstimatorVariant> parse_variants(const std::string& list);

/// A copy of `parameters` (a map or null) with those of the variant over it.
YAML::Node over(const YAML::Node& parameters, const EstimatorVariant& variant);

}  // namespace multipath_localization
