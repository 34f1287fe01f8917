#pragma once

#include <cstddef>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "core/plain_yaml.hpp"
#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// What `parse` makes of the YAML in a file that a node wrote to go on from; nothing where there is no such
/// file. Throws ParameterError, which says that the file is damaged, where it is none or `parse` throws.
template <class Parse>
auto read_state(const std::string& file, Parse parse) -> std::optional<decltype(parse(YAML::Node()))> {
  std::error_code unreadable;
  if (!std::filesystem::exists(file, unreadable) && !unreadable) return std::nullopt;
  try {
    return parse(parse_yaml_file(file));
  } catch (const std::exception& error) {
    throw ParameterError(file + " is damaged: " + error.what());
  }
}

/// Throws YAML::Exception or ParameterError unless there are that many finite numbers.
std::vector<double> finite_numbers(const YAML::Node& source, std::size_t count);

/// The place that is written [latitude, longitude, altitude] in degrees and metres. Throws as above, and
/// ParameterError where there is no such place.
Geodetic place_of(const YAML::Node& source);

}  // namespace multipath_localization
