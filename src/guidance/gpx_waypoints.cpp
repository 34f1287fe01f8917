#include "guidance/gpx_waypoints.hpp"

#include "guidance/waypoint_reading.hpp"
#include "guidance/xml_file.hpp"

namespace multipath_localization {

namespace {

using tinyxml2::XMLElement;

Eigen::Vector2d place_of_point(const XMLElement& point, const FilePlace& where) {
  const char* latitude = point.Attribute("lat");
  const char* longitude = point.Attribute("lon");
  if (latitude == nullptr || longitude == nullptr) throw where.error("a point without lat or lon");
  return {number(latitude, where), number(longitude, where)};
}

bool holds(const XMLElement& root, const std::string& name) {
  bool found = false;
  visit(root, [&](const XMLElement& element) { return found = found || local_name(element) == name; });
  return found;
}

}  // namespace

WaypointList read_gpx_waypoints(const std::string& file) {
  tinyxml2::XMLDocument document;
  read_xml(file, document);
  const XMLElement& root = *document.RootElement();
  const std::string line = holds(root, "rte") ? "rte" : "trk";
  MapFeatures features(file);
  visit(root, [&](const XMLElement& element) {
    const std::string name = local_name(element);
    const FilePlace where = place_of(file, element);
    if (name == line) features.begin_line();
    if (name == line + "pt") features.add_to_line(place_of_point(element, where), where);
    if (name == "wpt") features.add_point(place_of_point(element, where), where);
    return false;
  });
  return features.route();
}

}  // namespace multipath_localization
