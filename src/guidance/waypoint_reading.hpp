#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/guidance/waypoint_file.hpp"

namespace multipath_localization {

/// The part of a file that is being read, for what is to be said of it.
struct FilePlace {
  std::string file;
  std::string part = {};  ///< as a line's number, or "feature 3"; empty: the whole file

  /// `FILE:PART: reason`.
  [[nodiscard]] ParameterError error(const std::string& reason) const;
};

/// What `point` is that cannot be driven to; empty when it can. Latitude and longitude [deg] where it is
/// `on_earth`, else x and y in map [m].
std::string fault_of(const Eigen::Vector2d& point, bool on_earth);

/// Appends what stands at `place`. Throws ParameterError on a point that cannot be driven to, and above
/// kMostWaypoints.
void append(WaypointList& list, const Eigen::Vector2d& point, const FilePlace& place);

/// The number that a text is. Throws ParameterError, naming the place, where it is none.
double number(const std::string& text, const FilePlace& place);

/// A text without the blanks at its ends.
std::string trimmed(const std::string& text);

/// The lines and points of a file of a map, by latitude and longitude. A line is the route; points beside it
/// are places of interest. Where there is no line the points are the route, in their order.
class MapFeatures {
 public:
  explicit MapFeatures(std::string file) : file_{std::move(file)} {}

  /// Latitude and longitude [deg]. Throws ParameterError as append does.
  void add_point(const Eigen::Vector2d& place, const FilePlace& where) { append(points_, place, where); }
  /// Begins another line, to which add_to_line appends.
  void begin_line();
  void add_to_line(const Eigen::Vector2d& place, const FilePlace& where) { append(line_, place, where); }
  /// Drops the end of the line under way where it is its beginning: a ring is driven round by `loop`.
  void close_ring();

  /// Throws ParameterError where there are several lines, or neither line nor point.
  [[nodiscard]] WaypointList route() const;

 private:
  FilePlace file_;
  std::size_t lines_ = 0;
  WaypointList line_{true, {}};
  WaypointList points_{true, {}};
};

}  // namespace multipath_localization
