#pragma once

#include <tinyxml2.h>

#include <functional>
#include <string>

#include "guidance/waypoint_reading.hpp"

namespace multipath_localization {

/// Reads a file. Throws ParameterError where it cannot be read or is no XML, naming the line.
void read_xml(const std::string& file, tinyxml2::XMLDocument& document);

/// The name of an element without its namespace.
std::string local_name(const tinyxml2::XMLElement& element);

/// Calls for an element and all within it, in their order; not for what is within one for which it says true.
void visit(const tinyxml2::XMLElement& element, const std::function<bool(const tinyxml2::XMLElement&)>& take);

/// The line of the file that an element begins in.
FilePlace place_of(const std::string& file, const tinyxml2::XMLElement& element);

}  // namespace multipath_localization
