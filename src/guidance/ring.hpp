#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace multipath_localization {

/// A closed line in a plane, counter-clockwise round what it encloses. Places on it are told by the way from
/// its first corner [m], counted on over full rounds and back.
class Ring {
 public:
  /// Three corners at least, either way round.
  explicit Ring(std::vector<Eigen::Vector2d> corners);

  [[nodiscard]] const std::vector<Eigen::Vector2d>& corners() const { return corners_; }
  [[nodiscard]] double length() const { return stations_.back(); }
  [[nodiscard]] double area() const { return area_; }  ///< [m^2]
  [[nodiscard]] double station(std::size_t corner) const { return stations_[corner]; }
  [[nodiscard]] double longest_edge() const;  ///< its heading [rad]
  [[nodiscard]] Eigen::Vector2d at(double station) const;
  /// The same place in the first round [m].
  [[nodiscard]] double within_round(double station) const;
  [[nodiscard]] double nearest(const Eigen::Vector2d& place) const;  ///< within the first round [m]
  [[nodiscard]] std::size_t nearest_corner(const Eigen::Vector2d& place) const;
  /// Along it, counter-clockwise where `to` is the greater: both ends and the corners between.
  [[nodiscard]] std::vector<Eigen::Vector2d> way(double from, double to) const;
  /// Whether it encloses a place, or comes within `slack` of it [m].
  [[nodiscard]] bool contains(const Eigen::Vector2d& place, double slack) const;
  /// The parts of a line of that y that it encloses, as x from and to [m].
  [[nodiscard]] std::vector<std::pair<double, double>> sections(double y) const;

 private:
  /// The way from a station to a greater one.
  [[nodiscard]] std::vector<Eigen::Vector2d> counter_clockwise(double from, double to) const;
  [[nodiscard]] const Eigen::Vector2d& next(std::size_t corner) const {
    return corners_[(corner + 1) % corners_.size()];
  }

  std::vector<Eigen::Vector2d> corners_;
  double area_ = 0.0;
  std::vector<double> stations_;  ///< of the corners, and of the first one again
};

}  // namespace multipath_localization
