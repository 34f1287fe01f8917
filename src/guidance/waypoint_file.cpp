#include "multipath_localization/guidance/waypoint_file.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <stdexcept>
#include <string_view>

#include "core/plain_yaml.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "support/atomic_file.hpp"
#include "support/csv.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 100 * kMostWaypoints;

constexpr const char* kNoOrigin = "waiting for map's origin, to place waypoints by latitude and longitude";

enum class Format { kCsv, kYaml };

Format format_of(const std::string& file) {
  const std::string ending = fs::path(file).extension().string();
  if (ending == ".csv") return Format::kCsv;
  if (ending == ".yaml" || ending == ".yml") return Format::kYaml;
  throw ParameterError(file + ": a file of waypoints ends in .csv, .yaml or .yml");
}

/// The line being read, for what is to be said of it.
struct Place {
  const std::string& file;
  int line;

  [[nodiscard]] ParameterError error(const std::string& reason) const {
    ParameterError located(file + ":" + std::to_string(line) + ": " + reason);
    return located;
  }
};

/// What `point` is that cannot be driven to; empty when it can.
std::string fault_of(const Eigen::Vector2d& point, bool on_earth) {
  if (!point.allFinite()) return "not finite";
  if (on_earth) return valid(Geodetic{point.x(), point.y()}) ? "" : "no place on the Earth";
  if (point.lpNorm<Eigen::Infinity>() <= kFarthestWaypoint) return "";
  return "farther than " + std::to_string(std::lround(kFarthestWaypoint / 1e3)) + " km from map's origin";
}

/// Throws std::invalid_argument on the first of `points` in map that cannot be driven to.
void require_in_reach(const std::vector<Eigen::Vector2d>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string fault = fault_of(points[i], false);
    if (!fault.empty()) throw std::invalid_argument("waypoint " + std::to_string(i + 1) + " is " + fault);
  }
}

bool same(const Geodetic& a, const Geodetic& b) {
  return a.latitude_deg == b.latitude_deg && a.longitude_deg == b.longitude_deg && a.altitude == b.altitude;
}

/// In `map`, at the altitude of its origin.
Eigen::Vector2d on_ground(const Geodetic& place, const LocalFrame& map) {
  return map.to_map({place.latitude_deg, place.longitude_deg, map.datum().altitude});
}

void append(WaypointList& list, const Eigen::Vector2d& point, const Place& place) {
  if (list.points.size() == kMostWaypoints) {
    throw place.error("more than " + std::to_string(kMostWaypoints) + " waypoints");
  }
  const std::string fault = fault_of(point, list.on_earth);
  if (!fault.empty()) throw place.error("a waypoint is " + fault);
  list.points.push_back(point);
}

double number(const std::string& cell, const Place& place) {
  const std::optional<double> value = parse_number(cell);
  if (!value) throw place.error("'" + cell + "' is not a number");
  return *value;
}

bool named_on_earth(const std::vector<std::string>& names, const Place& place) {
  if (names == std::vector<std::string>{"x", "y"}) return false;
  if (names == std::vector<std::string>{"latitude", "longitude"}) return true;
  throw place.error("the first line names the columns: x,y or latitude,longitude");
}

WaypointList from_csv(const std::string& file) {
  CsvReader text(file);
  if (!text.open()) throw ParameterError(file + ": cannot be read");
  WaypointList list;
  std::vector<std::string> cells;
  if (!text.read(cells)) return list;
  list.on_earth = named_on_earth(cells, {file, text.line()});
  while (text.read(cells)) {
    const Place place{file, text.line()};
    if (cells.size() != 2) throw place.error(std::to_string(cells.size()) + " cells instead of 2");
    append(list, {number(cells[0], place), number(cells[1], place)}, place);
  }
  return list;
}

/// The names a point's coordinates have in a YAML file; none in the short form.
std::array<std::string, 2> names_in(const YAML::Node& item, const Place& place) {
  if (item.size() == 2) {
    if (item.IsSequence()) return {};
    if (item.IsMap() && item["x"] && item["y"]) return {"x", "y"};
    if (item.IsMap() && item["latitude"] && item["longitude"]) return {"latitude", "longitude"};
  }
  throw place.error("a waypoint is [x, y], {x: , y: } or {latitude: , longitude: }");
}

void append(WaypointList& list, const YAML::Node& item, const Place& place) {
  const auto names = names_in(item, place);
  const bool on_earth = names[0] == "latitude";
  if (list.points.empty()) list.on_earth = on_earth;
  if (list.on_earth != on_earth) throw place.error("a point of map among such on Earth, or the reverse");
  const YAML::Node first = names[0].empty() ? item[0] : item[names[0]];
  const YAML::Node second = names[1].empty() ? item[1] : item[names[1]];
  append(list, {yaml_number<double>(first), yaml_number<double>(second)}, place);
}

YAML::Node yaml_of(const std::string& file) {
  try {
    return parse_yaml_file(file);
  } catch (const ParameterError& error) {
    throw ParameterError(file + ": " + error.what());
  }
}

WaypointList from_yaml(const std::string& file) {
  WaypointList list;
  try {
    const YAML::Node content = yaml_of(file);
    const bool known = content.IsMap() && content.size() == 1 && content["waypoints"];
    if (!known || !content["waypoints"].IsSequence()) {
      throw Place{file, 1}.error("the file holds a list named waypoints and nothing else");
    }
    for (const YAML::Node& item : content["waypoints"]) append(list, item, {file, item.Mark().line + 1});
  } catch (const YAML::Exception& error) {
    throw Place{file, error.mark.line + 1}.error(error.msg);
  }
  return list;
}

}  // namespace

WaypointList moved(const WaypointList& waypoints, const std::optional<LocalFrame>& map) {
  WaypointList there = waypoints;
  if (waypoints.on_earth || !map) return there;
  there.map = map;
  if (!waypoints.map || same(waypoints.map->datum(), map->datum())) return there;
  for (Eigen::Vector2d& point : there.points) point = on_ground(waypoints.map->to_geodetic(point), *map);
  require_in_reach(there.points);
  return there;
}

std::vector<Eigen::Vector2d> to_map(const WaypointList& waypoints, const std::optional<LocalFrame>& map) {
  const std::size_t count = waypoints.points.size();
  if (count > kMostWaypoints) {
    throw std::invalid_argument(std::to_string(count) + " are more than " + std::to_string(kMostWaypoints));
  }
  if (waypoints.on_earth && !map) throw std::invalid_argument(kNoOrigin);
  std::vector<Eigen::Vector2d> points = moved(waypoints, map).points;
  if (waypoints.on_earth) {
    for (Eigen::Vector2d& point : points) point = on_ground({point.x(), point.y()}, *map);
  }
  require_in_reach(points);
  return points;
}

void append(WaypointList& waypoints, const Eigen::Vector2d& in_map, const std::optional<LocalFrame>& map) {
  const std::string fault = fault_of(in_map, false);
  if (!fault.empty()) throw std::invalid_argument("the point is " + fault);
  if (waypoints.points.size() >= kMostWaypoints) throw std::invalid_argument("there are too many waypoints");
  if (waypoints.points.empty()) waypoints.on_earth = map.has_value();
  if (!waypoints.on_earth) {
    waypoints = moved(waypoints, map);
    waypoints.points.push_back(in_map);
    return;
  }
  if (!map) throw std::invalid_argument(kNoOrigin);
  const Geodetic place = map->to_geodetic(in_map);
  waypoints.points.emplace_back(place.latitude_deg, place.longitude_deg);
}

std::optional<WaypointList> read_waypoints(const std::string& file) {
  const Format format = format_of(file);
  std::error_code unreadable;
  if (!fs::exists(file, unreadable) && !unreadable) return std::nullopt;
  const std::uintmax_t size = fs::file_size(file, unreadable);
  if (unreadable) throw ParameterError(file + ": " + unreadable.message());
  if (size > kMostBytes)
    throw ParameterError(file + ": larger than " + std::to_string(kMostBytes) + " bytes");
  return format == Format::kCsv ? from_csv(file) : from_yaml(file);
}

std::vector<Eigen::Vector2d> load_points(const YAML::Node& source, const std::string& path) {
  std::vector<Eigen::Vector2d> points;
  try {
    if (!source.IsSequence()) throw YAML::BadConversion(source.Mark());
    for (const YAML::Node& item : source) {
      const std::vector<double> pair = yaml_numbers(item);
      if (pair.size() != 2 || !std::isfinite(pair[0]) || !std::isfinite(pair[1])) {
        throw ParameterError(path + " holds what is not a pair of finite numbers");
      }
      points.emplace_back(pair[0], pair[1]);
    }
  } catch (const YAML::Exception&) {
    throw ParameterError(path + " is not a list of pairs [x, y]");
  }
  return points;
}

void write_waypoints(const std::string& file, const WaypointList& waypoints) {
  const bool csv = format_of(file) == Format::kCsv;
  const std::string first = waypoints.on_earth ? "latitude" : "x";
  const std::string second = waypoints.on_earth ? "longitude" : "y";
  PlainStream content;
  content << std::fixed << std::setprecision(waypoints.on_earth ? 9 : 4);
  content << (csv ? first + "," + second : "waypoints:") << "\n";
  for (const Eigen::Vector2d& point : waypoints.points) {
    if (csv) {
      content << point.x() << "," << point.y() << "\n";
    } else {
      content << "  - {" << first << ": " << point.x() << ", " << second << ": " << point.y() << "}\n";
    }
  }
  replace_file(file, content.str());
}

}  // namespace multipath_localization
