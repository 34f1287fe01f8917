#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "guidance/waypoint_reading.hpp"

namespace multipath_localization {

/// The content of a file. Throws ParameterError where it cannot be read, is no JSON, naming the line, or is
/// nested over 64 deep.
nlohmann::json read_json(const std::string& file);

/// What an object holds by that name; null where it is no object or holds nothing.
const nlohmann::json& member(const nlohmann::json& object, const std::string& name);

/// The items of a list. Throws ParameterError where it is none.
const nlohmann::json& items(const nlohmann::json& list, const std::string& name, const FilePlace& place);

/// The number that stands at `index` of a list. Throws ParameterError where there is none.
double number_at(const nlohmann::json& list, std::size_t index, const FilePlace& place);

}  // namespace multipath_localization
