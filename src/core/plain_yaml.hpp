#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace multipath_localization {

/// A copy in which nothing is shared: what an alias stands for is there as often as it is named, and no
/// change shows in two places. Throws ParameterError where it is nested over 64 deep, in itself for one, or
/// holds over 50 000 values and keys: a few lines of aliases of aliases stand for millions.
YAML::Node plain(const YAML::Node& source);

/// The first document of a text, as it stands there. Throws ParameterError where it is nested over 64 deep,
/// of which yaml-cpp's parser before 0.7 runs out of stack, or where it holds `:]`, of which that parser
/// comes to no end, and YAML::Exception where it is no YAML. A text that ends within braces and a colon,
/// `{key:`, is read as if a line ended there, for the same reason.
YAML::Node parse_yaml(const std::string& text);

/// The same of a file. Throws ParameterError also where it cannot be read.
YAML::Node parse_yaml_file(const std::string& file);

/// The number that a node holds, whatever locale the program has set: node.as<double>() and node.as<int>()
/// follow it. Throws YAML::Exception where it holds none.
template <class Number>
Number yaml_number(const YAML::Node& node);

/// Those of a list. Throws YAML::Exception where it is none, or not of numbers alone.
std::vector<double> yaml_numbers(const YAML::Node& list);

}  // namespace multipath_localization
