#include "multipath_localization/guidance/waypoint_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "core/plain_yaml.hpp"
#include "guidance/csv_waypoints.hpp"
#include "guidance/geojson_waypoints.hpp"
#include "guidance/gpx_waypoints.hpp"
#include "guidance/ground_station_waypoints.hpp"
#include "guidance/kml_waypoints.hpp"
#include "guidance/waypoint_reading.hpp"
#include "guidance/yaml_waypoints.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "support/atomic_file.hpp"

namespace multipath_localization {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 400 * kMostWaypoints;  // a point of GPX has a time and more

constexpr const char* kNoOrigin = "waiting for map's origin, to place waypoints by latitude and longitude";

/// A kind of file by its ending.
struct Format {
  std::string_view ending;
  WaypointList (*read)(const std::string& file);
  std::string (*text_of)(const WaypointList& waypoints);  ///< none where it can only be read
};

constexpr std::array<Format, 9> kFormats = {{{".csv", read_csv_waypoints, csv_of},
                                             {".yaml", read_yaml_waypoints, yaml_of},
                                             {".yml", read_yaml_waypoints, yaml_of},
                                             {".geojson", read_geojson_waypoints, geojson_of},
                                             {".json", read_geojson_waypoints, geojson_of},
                                             {".kml", read_kml_waypoints, nullptr},
                                             {".gpx", read_gpx_waypoints, nullptr},
                                             {".plan", read_plan_waypoints, nullptr},
                                             {".waypoints", read_mission_waypoints, nullptr}}};

const Format& format_of(const std::string& file) {
  const std::string ending = fs::path(file).extension().string();
  for (const Format& format : kFormats) {
    if (format.ending == ending) return format;
  }
  throw ParameterError(file +
                       ": a file of waypoints ends in .csv, .yaml, .yml, .geojson, .json, .kml, .gpx, .plan "
                       "or .waypoints");
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
  if (waypoints.field) throw std::invalid_argument("a field takes no waypoints");
  const std::string fault = fault_of(in_map, false);
  if (!fault.empty()) throw std::invalid_argument("the point is " + fault);
  if (waypoints.points.size() >= kMostWaypoints) throw std::invalid_argument("there are too many waypoints");
  if (waypoints.points.empty()) waypoints.on_earth = map.has_value();
  if (waypoints.on_earth && !map) throw std::invalid_argument(kNoOrigin);
  if (!waypoints.tasks.empty()) waypoints.tasks.emplace_back();
  if (!waypoints.on_earth) {
    waypoints = moved(waypoints, map);
    waypoints.points.push_back(in_map);
    return;
  }
  const Geodetic place = map->to_geodetic(in_map);
  waypoints.points.emplace_back(place.latitude_deg, place.longitude_deg);
}

std::optional<WaypointList> read_waypoints(const std::string& file) {
  const Format& format = format_of(file);
  std::error_code unreadable;
  if (!fs::exists(file, unreadable) && !unreadable) return std::nullopt;
  const std::uintmax_t size = fs::file_size(file, unreadable);
  if (unreadable) throw ParameterError(file + ": " + unreadable.message());
  if (size > kMostBytes)
    throw ParameterError(file + ": larger than " + std::to_string(kMostBytes) + " bytes");
  return format.read(file);
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
  const Format& format = format_of(file);
  if (format.text_of == nullptr) {
    throw ParameterError(file + ": can be read only; waypoints are written as .yaml, .csv or .geojson");
  }
  if (!waypoints.tasks.empty() && format.text_of != yaml_of) {
    throw ParameterError(file + ": speeds, waits and reverse can be written as .yaml alone");
  }
  replace_file(file, format.text_of(waypoints));
}

}  // namespace multipath_localization
