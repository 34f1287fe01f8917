#include "guidance/waypoint_reading.hpp"

#include <cmath>
#include <optional>

#include "multipath_localization/core/geodesy.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

ParameterError FilePlace::error(const std::string& reason) const {
  return ParameterError(file + (part.empty() ? "" : ":" + part) + ": " + reason);
}

std::string fault_of(const Eigen::Vector2d& point, bool on_earth) {
  if (!point.allFinite()) return "not finite";
  if (on_earth) return valid(Geodetic{point.x(), point.y()}) ? "" : "no place on the Earth";
  if (point.lpNorm<Eigen::Infinity>() <= kFarthestWaypoint) return "";
  return "farther than " + std::to_string(std::lround(kFarthestWaypoint / 1e3)) + " km from map's origin";
}

void append(WaypointList& list, const Eigen::Vector2d& point, const FilePlace& place) {
  if (list.points.size() == kMostWaypoints) {
    throw place.error("more than " + std::to_string(kMostWaypoints) + " waypoints");
  }
  const std::string fault = fault_of(point, list.on_earth);
  if (!fault.empty()) throw place.error("a waypoint is " + fault);
  list.points.push_back(point);
}

double number(const std::string& text, const FilePlace& place) {
  const std::optional<double> value = parse_number(text);
  if (!value) throw place.error("'" + text + "' is not a number");
  return *value;
}

std::string trimmed(const std::string& text) {
  constexpr const char* kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

void MapFeatures::begin_line() {
  ++lines_;
  line_.points.clear();
}

void MapFeatures::close_ring() {
  std::vector<Eigen::Vector2d>& ring = line_.points;
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

WaypointList MapFeatures::route() const {
  if (lines_ > 1) throw file_.error(std::to_string(lines_) + " lines: which of them is the route?");
  const WaypointList& route = lines_ == 1 ? line_ : points_;
  if (route.points.empty()) throw file_.error("neither a line nor points to drive along");
  return route;
}

}  // namespace multipath_localization
