#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace multipath_localization {

/// What to do on the way to a waypoint, and there.
struct WaypointTask {
  double speed = std::numeric_limits<double>::infinity();  ///< on the way to it, at most [m/s]
  double wait = 0.0;                                       ///< at rest there [s]; infinity: until resumed
  bool reverse = false;                                    ///< the way to it is driven backwards
  /// Of the arc on the way to it, half a circle at most, to the left, 0 for a line [1/m]. Where a waypoint of
  /// a route tells it, the ways to all others count as lines, and none is left out for lying near another.
  std::optional<double> curvature = std::nullopt;
};

/// What to do along a route beside driving from waypoint to waypoint.
struct RouteTasks {
  std::vector<WaypointTask> at;  ///< one for each waypoint, or none at all
  bool once = false;             ///< never driven round: a goal, or a plan to one
  /// At the last waypoint, counter-clockwise from east [rad]; a base that cannot turn on the spot ignores it.
  std::optional<double> final_heading = std::nullopt;
};

/// Waypoints in map, and how many of them a robot has passed.
class Route {
 public:
  /// Waypoints in map [m]. Throws std::invalid_argument when one is not finite, or where there are tasks but
  /// not as many.
  explicit Route(std::vector<Eigen::Vector2d> waypoints = {}, RouteTasks tasks = {});

  /// Takes other coordinates [m] for the same waypoints. Throws std::invalid_argument when they are not as
  /// many, or one is not finite.
  void move(std::vector<Eigen::Vector2d> waypoints);
  void pass() { ++passed_; }                                 ///< the next one
  void set_passed(std::size_t passed) { passed_ = passed; }  ///< over all rounds

  [[nodiscard]] const std::vector<Eigen::Vector2d>& waypoints() const { return waypoints_; }
  [[nodiscard]] const RouteTasks& tasks() const { return tasks_; }
  [[nodiscard]] bool empty() const { return waypoints_.empty(); }
  [[nodiscard]] double extent() const { return extent_; }  ///< from the first to the farthest from it [m]
  [[nodiscard]] std::size_t passed() const { return passed_; }  ///< over all rounds
  [[nodiscard]] std::size_t target() const;                     ///< index of the waypoint to be passed next
  [[nodiscard]] int rounds() const;                             ///< completed
  [[nodiscard]] double progress() const;                        ///< waypoints passed, over those of a round
  [[nodiscard]] bool passed_all() const { return passed_ > 0 && target() == 0; }

  /// What is to be done at the waypoint `ahead` of the next one, counted round.
  [[nodiscard]] WaypointTask task(std::size_t ahead = 0) const;
  [[nodiscard]] const Eigen::Vector2d& waypoint(std::size_t ahead) const;
  /// Whether the robot comes to rest there: it waits, or turns to drive the other way.
  [[nodiscard]] bool stops(std::size_t ahead) const;
  [[nodiscard]] bool has_arcs() const;  ///< or lines told as such: curvatures

 private:
  std::vector<Eigen::Vector2d> waypoints_;
  RouteTasks tasks_;
  double extent_;
  std::size_t passed_ = 0;
};

}  // namespace multipath_localization
