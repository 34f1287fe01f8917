#include "ros/saved_state/state_file.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

std::vector<double> finite_numbers(const YAML::Node& source, std::size_t count) {
  std::vector<double> values = yaml_numbers(source);
  const bool finite = std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (values.size() != count || !finite)
    throw ParameterError("a list is not of " + std::to_string(count) + " finite numbers");
  return values;
}

Geodetic place_of(const YAML::Node& source) {
  const std::vector<double> numbers = finite_numbers(source, 3);
  const Geodetic place{numbers[0], numbers[1], numbers[2]};
  if (!valid(place)) throw ParameterError("no place has such a latitude, longitude and altitude");
  return place;
}

}  // namespace multipath_localization
