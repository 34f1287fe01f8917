#include "ros/map/datum_file.hpp"

#include <cstdio>

#include "ros/saved_state/state_file.hpp"
#include "support/atomic_file.hpp"

namespace multipath_localization {

namespace {

/// Latitude and longitude to a tenth of a millimetre.
std::string text_of(const Geodetic& datum) {
  char text[200];
  std::snprintf(text, sizeof(text),
                "# Origin of map: latitude, longitude [deg], altitude [m]\ndatum: [%.9f, %.9f, %.4f]\n",
                datum.latitude_deg, datum.longitude_deg, datum.altitude);
  return text;
}

Geodetic parsed(const YAML::Node& content) {
  if (!content.IsMap() || content.size() != 1 || !content["datum"])
    throw ParameterError("it does not hold datum: [latitude, longitude, altitude]");
  return place_of(content["datum"]);
}

}  // namespace

std::optional<Geodetic> read_datum(const std::string& file) { return read_state(file, parsed); }

void write_datum(const std::string& file, const Geodetic& datum) { replace_file(file, text_of(datum)); }

}  // namespace multipath_localization
