#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// A place on a path.
struct PathPoint {
  Eigen::Vector2d position;
  double heading;    ///< counter-clockwise from east, counted on over full turns [rad]
  double curvature;  ///< to the left [1/m]
};

/// A line where `curvature` is zero, else an arc.
struct PathPiece {
  double begin;  ///< along the path [m]
  double length;
  Eigen::Vector2d start;
  double heading;  ///< at its start [rad]
  double curvature;

  [[nodiscard]] double end() const { return begin + length; }
  /// The place `u` [m] from its start, prolonged beyond its ends.
  [[nodiscard]] PathPoint at(double u) const;
  /// How far from its start the place nearest to `position` lies, within `from` and `to` [m].
  [[nodiscard]] double nearest(const Eigen::Vector2d& position, double from, double to) const;
};

/// How far a path goes on with one curvature.
struct PathArc {
  double length;     ///< [m]
  double curvature;  ///< to the left; 0: straight [1/m]
};

/// Straight lines along vertices in map [m], and an arc at each corner: the largest that passes within
/// `corner_radius` of the vertex and takes at most half of each leg. Vertices nearer than that to the one
/// before, or to the last, bend nothing: the direction between such is that of their errors. Where the path
/// turns back, so that no arc fits, it has a cusp.
class Path {
 public:
  /// At least one vertex; all finite.
  Path(const std::vector<Eigen::Vector2d>& vertices, double corner_radius);
  /// Along vertices in map [m], where `curvatures` has for each but the first that of the arc on the way to
  /// it, to the left, 0 for a line [1/m]. Nothing is left out; corners between lines are rounded as above.
  Path(const std::vector<Eigen::Vector2d>& vertices, const std::vector<double>& curvatures,
       double corner_radius);
  /// From a pose in map along arcs. Its vertices are its two ends.
  Path(const Pose2& start, const std::vector<PathArc>& arcs);

  [[nodiscard]] double length() const { return pieces_.back().end(); }
  [[nodiscard]] const std::vector<PathPiece>& pieces() const { return pieces_; }
  [[nodiscard]] std::size_t piece_at(double s) const;  ///< index of the piece `s` [m] along the path

  /// The place `s` [m] along the path, prolonged straight beyond its ends.
  [[nodiscard]] PathPoint at(double s) const;
  /// How far along the path the place nearest to `position` lies, within `from` and `to` [m].
  [[nodiscard]] double nearest(const Eigen::Vector2d& position, double from, double to) const;
  /// Where the path comes by a vertex [m].
  [[nodiscard]] double station(std::size_t vertex) const { return stations_[vertex]; }
  /// Whether it has a cusp there [m].
  [[nodiscard]] bool turns_back_at(double station) const;
  /// Mean curvature between two places, the first before the other, a cusp's turn included [1/m].
  [[nodiscard]] double mean_curvature(double from, double to) const;

 private:
  void add_corner(const Eigen::Vector2d& from, const Eigen::Vector2d& corner, const Eigen::Vector2d& to,
                  double corner_radius);
  void add_piece(double length, double curvature);
  void add_arc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double curvature);
  void turn_to(double heading);
  void find_stations(const std::vector<Eigen::Vector2d>& vertices, const std::vector<std::size_t>& bends);

  std::vector<PathPiece> pieces_;
  std::vector<double> corners_;   ///< stations of the vertices that bend the path, and of both ends
  std::vector<double> stations_;  ///< of all vertices
};

}  // namespace multipath_localization
