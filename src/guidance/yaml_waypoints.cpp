#include "guidance/yaml_waypoints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>

#include "core/plain_yaml.hpp"
#include "guidance/polygon_inset.hpp"
#include "guidance/waypoint_reading.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

constexpr const char* kForms = "a waypoint is [x, y], {x: , y: } or {latitude: , longitude: }";
constexpr const char* kFieldForm =
    "a field has a border, a list of corners, and a width, and heading, start and speed as wanted";
constexpr const char* kUntilResumed = "resume";

/// The names a point's coordinates have; none in the short form.
std::array<std::string, 2> names_in(const YAML::Node& item, const FilePlace& place) {
  if (item.IsSequence() && item.size() == 2) return {};
  if (item.IsMap() && item["x"] && item["y"]) return {"x", "y"};
  if (item.IsMap() && item["latitude"] && item["longitude"]) return {"latitude", "longitude"};
  throw place.error(kForms);
}

double positive(const YAML::Node& value, const std::string& name, const FilePlace& place) {
  const auto number = yaml_number<double>(value);
  if (!(number > 0.0) || !std::isfinite(number)) throw place.error(name + " is a number above 0");
  return number;
}

/// What a waypoint says beside its coordinates, as many names.
WaypointTask task_in(const YAML::Node& item, std::size_t coordinates, const FilePlace& place) {
  WaypointTask task;
  std::size_t known = coordinates;
  if (const YAML::Node speed = item["speed"]) {
    task.speed = positive(speed, "speed", place);
    ++known;
  }
  if (const YAML::Node wait = item["wait"]) {
    const bool by_call = wait.IsScalar() && wait.Scalar() == kUntilResumed;
    task.wait = by_call ? std::numeric_limits<double>::infinity() : positive(wait, "wait", place);
    ++known;
  }
  if (const YAML::Node reverse = item["reverse"]) {
    task.reverse = reverse.as<bool>();
    ++known;
  }
  if (known != item.size())
    throw place.error(std::string(kForms) + ", with speed, wait and reverse as wanted");
  return task;
}

void append(WaypointList& list, const YAML::Node& item, const FilePlace& place) {
  const auto names = names_in(item, place);
  const bool on_earth = names[0] == "latitude";
  if (list.points.empty()) list.on_earth = on_earth;
  if (list.on_earth != on_earth) throw place.error("a point of map among such on Earth, or the reverse");
  const YAML::Node first = names[0].empty() ? item[0] : item[names[0]];
  const YAML::Node second = names[1].empty() ? item[1] : item[names[1]];
  append(list, {yaml_number<double>(first), yaml_number<double>(second)}, place);
  list.tasks.push_back(item.IsMap() ? task_in(item, names.size(), place) : WaypointTask{});
}

bool says_nothing(const WaypointTask& task) {
  return std::isinf(task.speed) && task.wait == 0.0 && !task.reverse;
}

std::string text_of(const WaypointTask& task) {
  PlainStream text;
  if (std::isfinite(task.speed)) text << ", speed: " << task.speed;
  if (task.wait > 0.0 && std::isinf(task.wait)) text << ", wait: " << kUntilResumed;
  if (task.wait > 0.0 && std::isfinite(task.wait)) text << ", wait: " << task.wait;
  if (task.reverse) text << ", reverse: true";
  return text.str();
}

/// A member of a field, one of as many as `known` counts; undefined where it is not there.
YAML::Node member(const YAML::Node& field, const std::string& name, std::size_t& known) {
  const YAML::Node value = field[name];
  if (value) ++known;
  return value;
}

FieldTask field_task_in(const YAML::Node& field, std::size_t corners, const FilePlace& place) {
  std::size_t known = 1;  // the border
  FieldTask task{positive(member(field, "width", known), "width", place)};
  if (const YAML::Node heading = member(field, "heading", known)) {
    task.heading = yaml_number<double>(heading);
    if (!std::isfinite(*task.heading)) throw place.error("heading is a number");
  }
  if (const YAML::Node start = member(field, "start", known)) {
    const auto corner = yaml_number<int>(start);
    if (corner < 1 || static_cast<std::size_t>(corner) > corners) {
      throw place.error("start is the number of a corner, 1 being the first");
    }
    task.start = static_cast<std::size_t>(corner - 1);
  }
  if (const YAML::Node speed = member(field, "speed", known)) task.speed = positive(speed, "speed", place);
  if (known != field.size()) throw place.error(kFieldForm);
  return task;
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

/// Its border, and how it is to be worked on.
WaypointList field_in(const YAML::Node& field, const std::string& file) {
  const FilePlace place = place_of(file, field.Mark());
  if (!field.IsMap() || !field["border"] || !field["border"].IsSequence() || !field["width"]) {
    throw place.error(kFieldForm);
  }
  WaypointList list;
  for (const YAML::Node& item : field["border"]) append(list, item, place_of(file, item.Mark()));
  if (!std::all_of(list.tasks.begin(), list.tasks.end(), says_nothing)) {
    throw place.error("a corner of a field has coordinates alone");
  }
  list.tasks.clear();
  const std::string fault = fault_of_polygon(list.points);
  if (!fault.empty()) throw place.error("the border of the field has " + fault);
  list.field = field_task_in(field, list.points.size(), place);
  return list;
}

}  // namespace

WaypointList read_yaml_waypoints(const std::string& file) {
  WaypointList list;
  try {
    const YAML::Node content = content_of(file);
    if (content.IsMap() && content.size() == 1 && content["field"]) return field_in(content["field"], file);
    const bool known = content.IsMap() && content.size() == 1 && content["waypoints"];
    if (!known || !content["waypoints"].IsSequence()) {
      throw FilePlace{file, "1"}.error("the file holds a list named waypoints, or a field, and nothing else");
    }
    for (const YAML::Node& item : content["waypoints"]) append(list, item, place_of(file, item.Mark()));
  } catch (const YAML::Exception& error) {
    throw place_of(file, error.mark).error(error.msg);
  }
  if (std::all_of(list.tasks.begin(), list.tasks.end(), says_nothing)) list.tasks.clear();
  return list;
}

std::string yaml_of(const WaypointList& waypoints) {
  const std::string first = waypoints.on_earth ? "latitude" : "x";
  const std::string second = waypoints.on_earth ? "longitude" : "y";
  PlainStream content;
  content << std::fixed << std::setprecision(waypoints.on_earth ? 9 : 4) << "waypoints:\n";
  for (std::size_t i = 0; i < waypoints.points.size(); ++i) {
    const Eigen::Vector2d& point = waypoints.points[i];
    content << "  - {" << first << ": " << point.x() << ", " << second << ": " << point.y()
            << (waypoints.tasks.empty() ? "" : text_of(waypoints.tasks[i])) << "}\n";
  }
  return content.str();
}

}  // namespace multipath_localization
