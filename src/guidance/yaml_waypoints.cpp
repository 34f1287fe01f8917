#include "guidance/yaml_waypoints.hpp"

#include <array>
#include <iomanip>

#include "core/plain_yaml.hpp"
#include "guidance/waypoint_reading.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

/// The names a point's coordinates have; none in the short form.
std::array<std::string, 2> names_in(const YAML::Node& item, const FilePlace& place) {
  if (item.size() == 2) {
    if (item.IsSequence()) return {};
    if (item.IsMap() && item["x"] && item["y"]) return {"x", "y"};
    if (item.IsMap() && item["latitude"] && item["longitude"]) return {"latitude", "longitude"};
  }
  throw place.error("a waypoint is [x, y], {x: , y: } or {latitude: , longitude: }");
}

void append(WaypointList& list, const YAML::Node& item, const FilePlace& place) {
  const auto names = names_in(item, place);
  const bool on_earth = names[0] == "latitude";
  if (list.points.empty()) list.on_earth = on_earth;
  if (list.on_earth != on_earth) throw place.error("a point of map among such on Earth, or the reverse");
  const YAML::Node first = names[0].empty() ? item[0] : item[names[0]];
  const YAML::Node second = names[1].empty() ? item[1] : item[names[1]];
  append(list, {yaml_number<double>(first), yaml_number<double>(second)}, place);
}

YAML::Node content_of(const std::string& file) {
  try {
    return parse_yaml_file(file);
  } catch (const ParameterError& error) {
    throw FilePlace{file}.error(error.what());
  }
}

FilePlace place_of(const std::string& file, const YAML::Mark& mark) {
  return {file, std::to_string(mark.line + 1)};
}

}  // namespace

WaypointList read_yaml_waypoints(const std::string& file) {
  WaypointList list;
  try {
    const YAML::Node content = content_of(file);
    const bool known = content.IsMap() && content.size() == 1 && content["waypoints"];
    if (!known || !content["waypoints"].IsSequence()) {
      throw FilePlace{file, "1"}.error("the file holds a list named waypoints and nothing else");
    }
    for (const YAML::Node& item : content["waypoints"]) append(list, item, place_of(file, item.Mark()));
  } catch (const YAML::Exception& error) {
    throw place_of(file, error.mark).error(error.msg);
  }
  return list;
}

std::string yaml_of(const WaypointList& waypoints) {
  const std::string first = waypoints.on_earth ? "latitude" : "x";
  const std::string second = waypoints.on_earth ? "longitude" : "y";
  PlainStream content;
  content << std::fixed << std::setprecision(waypoints.on_earth ? 9 : 4) << "waypoints:\n";
  for (const Eigen::Vector2d& point : waypoints.points) {
    content << "  - {" << first << ": " << point.x() << ", " << second << ": " << point.y() << "}\n";
  }
  return content.str();
}

}  // namespace multipath_localization
