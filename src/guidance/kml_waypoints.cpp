#include "guidance/kml_waypoints.hpp"

#include <sstream>

#include "guidance/waypoint_reading.hpp"
#include "guidance/xml_file.hpp"

namespace multipath_localization {

namespace {

using tinyxml2::XMLElement;

/// Longitude, latitude and, where it is there, altitude, with commas between.
Eigen::Vector2d place_in(const std::string& text, const FilePlace& where) {
  std::istringstream rest(text);
  std::string longitude;
  std::string latitude;
  std::getline(rest, longitude, ',');
  std::getline(rest, latitude, ',');
  return {number(latitude, where), number(longitude, where)};
}

/// The places of the coordinates within an element, blanks between them.
std::vector<Eigen::Vector2d> places_in(const XMLElement& shape, const FilePlace& where) {
  std::vector<Eigen::Vector2d> places;
  visit(shape, [&](const XMLElement& element) {
    if (local_name(element) == "innerBoundaryIs") return true;
    if (local_name(element) != "coordinates" || element.GetText() == nullptr) return false;
    std::istringstream text(element.GetText());
    for (std::string place; text >> place;) places.push_back(place_in(place, where));
    return true;
  });
  return places;
}

void take_line(const std::vector<Eigen::Vector2d>& places, const FilePlace& where, MapFeatures& features) {
  features.begin_line();
  for (const Eigen::Vector2d& place : places) features.add_to_line(place, where);
}

}  // namespace

WaypointList read_kml_waypoints(const std::string& file) {
  tinyxml2::XMLDocument document;
  read_xml(file, document);
  MapFeatures features(file);
  visit(*document.RootElement(), [&](const XMLElement& element) {
    const std::string name = local_name(element);
    const FilePlace where = place_of(file, element);
    if (name == "Point") {
      for (const Eigen::Vector2d& place : places_in(element, where)) features.add_point(place, where);
    } else if (name == "LineString") {
      take_line(places_in(element, where), where, features);
    } else if (name == "Polygon") {
      take_line(places_in(element, where), where, features);
      features.close_ring();
    } else {
      return false;
    }
    return true;
  });
  return features.route();
}

}  // namespace multipath_localization
