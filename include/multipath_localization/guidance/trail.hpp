#pragma once

#include <Eigen/Core>
#include <deque>

namespace multipath_localization {

/// Where a robot has just been, in map.
class Trail {
 public:
  /// Keeps the last `length` [m] of it.
  explicit Trail(double length) : length_(length) {}

  void add(const Eigen::Vector2d& position);
  void clear() { places_.clear(); }

  [[nodiscard]] bool empty() const { return places_.empty(); }
  [[nodiscard]] const Eigen::Vector2d& latest() const { return places_.back(); }
  /// Whether it comes by a place, within some decimetres.
  [[nodiscard]] bool comes_by(const Eigen::Vector2d& place) const;

 private:
  double length_;
  std::deque<Eigen::Vector2d> places_;  ///< the latest last
};

}  // namespace multipath_localization
