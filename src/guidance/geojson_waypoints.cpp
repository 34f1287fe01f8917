#include "guidance/geojson_waypoints.hpp"

#include <iomanip>
#include <optional>

#include "guidance/json_file.hpp"
#include "guidance/polygon_inset.hpp"
#include "guidance/waypoint_reading.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

using nlohmann::json;

/// Longitude comes first.
Eigen::Vector2d place_of(const json& position, const FilePlace& where) {
  return {number_at(position, 1, where), number_at(position, 0, where)};
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file), features_(file) {}

  WaypointList read(const json& content) {
    refuse_other_systems(content);
    const json& type = member(content, "type");
    if (type == "FeatureCollection") {
      std::size_t number = 0;
      for (const json& feature : items(member(content, "features"), "features", {file_})) {
        take_feature(feature, {file_, "feature " + std::to_string(++number)});
      }
    } else if (type == "Feature") {
      take_feature(content, {file_});
    } else {
      take(content, {file_});
    }
    WaypointList route = features_.route();
    if (!field_) return route;
    const std::string fault = fault_of_polygon(route.points);
    if (!fault.empty()) throw FilePlace{file_}.error("the border of the field has " + fault);
    route.field = field_;
    return route;
  }

 private:
  /// RFC 7946 knows WGS 84 alone; its forerunner could name another.
  void refuse_other_systems(const json& content) const {
    const json& system = member(content, "crs");
    if (system.is_null()) return;
    const std::string name = system.dump();
    if (name.find("CRS84") == std::string::npos && name.find("4326") == std::string::npos) {
      throw FilePlace{file_}.error("its coordinates are not of WGS 84: " + name.substr(0, 100));
    }
  }

  void take_feature(const json& feature, const FilePlace& where) {
    const json& geometry = member(feature, "geometry");
    take(geometry, where);
    const json& width = member(member(feature, "properties"), "coverage_width");
    if (width.is_null()) return;
    if (member(geometry, "type") != "Polygon") throw where.error("coverage_width, and no Polygon");
    if (!width.is_number() || !(width.get<double>() > 0.0)) {
      throw where.error("coverage_width is a number above 0");
    }
    if (member(geometry, "coordinates").size() > 1) throw where.error("a field with holes");
    field_ = FieldTask{width.get<double>()};
  }

  void take(const json& geometry, const FilePlace& where) {
    const json& type = member(geometry, "type");
    const json& coordinates = member(geometry, "coordinates");
    if (type == "Point") {
      features_.add_point(place_of(coordinates, where), where);
    } else if (type == "MultiPoint") {
      for (const json& position : items(coordinates, "coordinates", where)) {
        features_.add_point(place_of(position, where), where);
      }
    } else if (type == "LineString") {
      take_line(coordinates, where);
    } else if (type == "Polygon") {
      const json& rings = items(coordinates, "rings", where);
      if (rings.empty()) throw where.error("a polygon without a ring");
      take_line(rings[0], where);
      features_.close_ring();
    } else {
      const std::string named = type.is_string() ? type.get<std::string>().substr(0, 50) : "nothing";
      throw where.error("neither a LineString, Polygon, Point nor MultiPoint but " + named);
    }
  }

  void take_line(const json& positions, const FilePlace& where) {
    features_.begin_line();
    for (const json& position : items(positions, "coordinates", where)) {
      features_.add_to_line(place_of(position, where), where);
    }
  }

  std::string file_;
  MapFeatures features_;
  std::optional<FieldTask> field_;
};

}  // namespace

WaypointList read_geojson_waypoints(const std::string& file) { return Reader(file).read(read_json(file)); }

std::string geojson_of(const WaypointList& waypoints) {
  if (waypoints.points.empty()) throw ParameterError("GeoJSON without a waypoint would be no route");
  if (!waypoints.on_earth && !waypoints.map) {
    throw ParameterError("GeoJSON wants latitude and longitude, and map's origin is not known");
  }
  PlainStream places;
  places << std::fixed << std::setprecision(9);
  for (const Eigen::Vector2d& point : waypoints.points) {
    const Geodetic place =
        waypoints.on_earth ? Geodetic{point.x(), point.y()} : waypoints.map->to_geodetic(point);
    places << (places.tellp() > 0 ? ", [" : "[") << place.longitude_deg << ", " << place.latitude_deg << "]";
  }
  const bool line = waypoints.points.size() > 1;
  const std::string begin =
      R"({"type": "Feature", "properties": {"name": "waypoints"}, "geometry": {"type": ")";
  if (!line) return begin + R"(Point", "coordinates": )" + places.str() + "}}\n";
  return begin + R"(LineString", "coordinates": [)" + places.str() + "]}}\n";
}

}  // namespace multipath_localization
