#include "guidance/csv_waypoints.hpp"

#include <iomanip>
#include <string>
#include <vector>

#include "guidance/waypoint_reading.hpp"
#include "support/csv.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

bool named_on_earth(const std::vector<std::string>& names, const FilePlace& place) {
  if (names == std::vector<std::string>{"x", "y"}) return false;
  if (names == std::vector<std::string>{"latitude", "longitude"}) return true;
  throw place.error("the first line names the columns: x,y or latitude,longitude");
}

}  // namespace

WaypointList read_csv_waypoints(const std::string& file) {
  CsvReader text(file);
  if (!text.open()) throw FilePlace{file}.error("cannot be read");
  WaypointList list;
  std::vector<std::string> cells;
  if (!text.read(cells)) return list;
  list.on_earth = named_on_earth(cells, {file, std::to_string(text.line())});
  while (text.read(cells)) {
    const FilePlace place{file, std::to_string(text.line())};
    if (cells.size() != 2) throw place.error(std::to_string(cells.size()) + " cells instead of 2");
    append(list, {number(cells[0], place), number(cells[1], place)}, place);
  }
  return list;
}

std::string csv_of(const WaypointList& waypoints) {
  PlainStream content;
  content << std::fixed << std::setprecision(waypoints.on_earth ? 9 : 4);
  content << (waypoints.on_earth ? "latitude,longitude\n" : "x,y\n");
  for (const Eigen::Vector2d& point : waypoints.points) content << point.x() << "," << point.y() << "\n";
  return content.str();
}

}  // namespace multipath_localization
