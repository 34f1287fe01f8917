#include "ros/map/datum_parameter.hpp"

#include <string>

namespace multipath_localization {

void DatumParameter::fields(ParameterVisitor& field) {
  field("datum", numbers, {-1e5, 1e5}, "deg, deg, rad, m",
        "latitude, longitude and perhaps yaw and altitude of map's origin; the yaw, counter-clockwise from "
        "east, has to be 0; empty: from the first measurements");
  if (!given()) return;
  if (numbers.size() == 1 || numbers.size() > 4 || !valid({numbers[0], numbers[1], 0.0})) {
    throw ParameterError(
        "datum is not [latitude, longitude, yaw, altitude], the last two of which may be left out");
  }
  if (numbers.size() > 2 && numbers[2] != 0.0) {
    throw ParameterError(
        "datum is turned by " + std::to_string(numbers[2]) +
        " rad: the third number is the yaw of map, whose axes are east, north and up here; make it 0 "
        "and turn what is given in map instead. The altitude comes fourth");
  }
}

std::optional<Geodetic> DatumParameter::place(double otherwise) const {
  if (!given()) return std::nullopt;
  return Geodetic{numbers[0], numbers[1], numbers.size() > 3 ? numbers[3] : otherwise};
}

}  // namespace multipath_localization
