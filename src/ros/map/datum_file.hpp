#pragma once

#include <optional>
#include <string>

#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

/// The datum that was saved in a YAML file: `datum: [latitude, longitude, altitude]` in degrees and metres,
/// as the parameter of that name; nothing where there is no such file. Throws ParameterError where it cannot
/// be read, or holds anything else.
std::optional<Geodetic> read_datum(const std::string& file);

/// Saves a datum. The file is replaced as a whole and is on the disk afterwards: no moment leaves half of it
/// behind. Missing folders are made. Throws std::system_error and leaves the old file where it cannot.
void write_datum(const std::string& file, const Geodetic& datum);

}  // namespace multipath_localization
