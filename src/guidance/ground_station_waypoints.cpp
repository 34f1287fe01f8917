#include "guidance/ground_station_waypoints.hpp"

#include <fstream>
#include <sstream>

#include "guidance/json_file.hpp"
#include "guidance/waypoint_reading.hpp"

namespace multipath_localization {

namespace {

using nlohmann::json;

constexpr int kWaypointCommand = 16;  // MAV_CMD_NAV_WAYPOINT, whose parameters 5 and 6 are the place

[[noreturn]] void refuse_command(const std::string& command, const FilePlace& where) {
  throw where.error("command " + command + " is no waypoint (16) and would not be carried out");
}

void refuse_fence(const json& fence, const FilePlace& file) {
  for (const char* shape : {"circles", "polygons"}) {
    if (!member(fence, shape).empty()) throw file.error("its geofence would not be kept: remove it");
  }
}

Eigen::Vector2d place_of(const json& item, const FilePlace& where) {
  if (member(item, "type") != "SimpleItem") throw where.error("no single waypoint but a pattern of them");
  const json& command = member(item, "command");
  if (command != kWaypointCommand) refuse_command(command.dump().substr(0, 20), where);
  const json& parameters = member(item, "params");
  return {number_at(parameters, 4, where), number_at(parameters, 5, where)};
}

/// A line of a mission as text.
struct Row {
  int line;
  std::vector<std::string> cells;
};

// Cells of a row by their meaning: index, current, frame, command, four parameters, place, altitude, goes on.
constexpr std::size_t kFrame = 2;
constexpr std::size_t kCommand = 3;
constexpr std::size_t kLatitude = 8;
constexpr std::size_t kLongitude = 9;
constexpr std::size_t kCells = 12;

std::vector<Row> rows_of(const std::string& file) {
  std::ifstream text(file);
  if (!text) throw FilePlace{file}.error("cannot be read");
  std::string line;
  std::getline(text, line);
  if (trimmed(line) != "QGC WPL 110") throw FilePlace{file, "1"}.error("the first line is not QGC WPL 110");
  std::vector<Row> rows;
  for (int number_of_line = 2; std::getline(text, line); ++number_of_line) {
    if (trimmed(line).empty()) continue;
    Row row{number_of_line, {}};
    std::istringstream rest(line);
    for (std::string cell; rest >> cell;) row.cells.push_back(cell);
    if (row.cells.size() != kCells) {
      throw FilePlace{file, std::to_string(number_of_line)}.error(std::to_string(row.cells.size()) +
                                                                  " cells instead of 12");
    }
    rows.push_back(row);
  }
  return rows;
}

bool begins_with_home(const std::vector<Row>& rows) {
  return rows.size() > 1 && rows[0].cells[kFrame] == "0" && rows[1].cells[kFrame] != "0";
}

}  // namespace

WaypointList read_plan_waypoints(const std::string& file) {
  const FilePlace whole{file};
  const json content = read_json(file);
  if (member(content, "fileType") != "Plan") throw whole.error("no plan of QGroundControl");
  refuse_fence(member(content, "geoFence"), whole);
  WaypointList list{true, {}};
  std::size_t number_of_item = 0;
  for (const json& item : items(member(member(content, "mission"), "items"), "items", whole)) {
    const FilePlace where{file, "item " + std::to_string(++number_of_item)};
    append(list, place_of(item, where), where);
  }
  return list;
}

WaypointList read_mission_waypoints(const std::string& file) {
  const std::vector<Row> rows = rows_of(file);
  WaypointList list{true, {}};
  for (std::size_t i = begins_with_home(rows) ? 1 : 0; i < rows.size(); ++i) {
    const FilePlace where{file, std::to_string(rows[i].line)};
    const std::vector<std::string>& cells = rows[i].cells;
    if (cells[kCommand] != std::to_string(kWaypointCommand)) refuse_command(cells[kCommand], where);
    append(list, {number(cells[kLatitude], where), number(cells[kLongitude], where)}, where);
  }
  return list;
}

}  // namespace multipath_localization
