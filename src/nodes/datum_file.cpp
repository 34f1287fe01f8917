#include "nodes/datum_file.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

#include "multipath_localization/core/atomic_file.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

namespace fs = std::filesystem;

/// Latitude and longitude to a tenth of a millimetre.
std::string text_of(const Geodetic& datum) {
  char text[200];
  std::snprintf(text, sizeof(text),
                "# Origin of map: latitude, longitude [deg], altitude [m]\ndatum: [%.9f, %.9f, %.4f]\n",
                datum.latitude_deg, datum.longitude_deg, datum.altitude);
  return text;
}

}  // namespace

std::optional<Geodetic> read_datum(const std::string& file) {
  std::error_code unreadable;
  if (!fs::exists(file, unreadable) && !unreadable) return std::nullopt;
  try {
    const YAML::Node content = YAML::LoadFile(file);
    const bool is_datum = content.IsMap() && content.size() == 1 && content["datum"];
    const auto numbers = is_datum ? content["datum"].as<std::vector<double>>() : std::vector<double>();
    if (numbers.size() == 3) {
      const Geodetic datum{numbers[0], numbers[1], numbers[2]};
      if (valid(datum) && std::isfinite(datum.altitude)) return datum;
    }
  } catch (const YAML::Exception& error) {
    throw ParameterError(file + " is damaged: " + error.what());
  }
  throw ParameterError(file + " is damaged: it does not hold datum: [latitude, longitude, altitude]");
}

void write_datum(const std::string& file, const Geodetic& datum) { replace_file(file, text_of(datum)); }

}  // namespace multipath_localization
