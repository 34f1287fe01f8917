#pragma once

#include <ros/time.h>

#include <optional>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What a node that does not keep up with its messages leaves out, so that it stays with the present: it sums
/// up odometry instead of handing on each increment, and does not weigh measurements.
///
/// Messages are taken in turns: all that have come by the start of a turn, then all that came meanwhile. One
/// that is taken `max_lag` after its turn began has waited that long at least.
class Backlog {
 public:
  /// `max_lag` [s]
  explicit Backlog(double max_lag) : max_lag_(max_lag) {}

  /// A turn begins with the next message.
  void begin_turn() { begun_.reset(); }
  /// A message is taken; returns whether it has waited too long.
  bool take(ros::WallTime now);

  /// Counts what was left out.
  void count_merged() { ++left_out_.increments; }
  void count_unweighed() { ++left_out_.measurements; }

  struct LeftOut {
    unsigned increments = 0;    ///< of odometry, summed up
    unsigned measurements = 0;  ///< not weighed
  };
  /// Since the last call.
  LeftOut take_left_out();

 private:
  double max_lag_;
  std::optional<ros::WallTime> begun_;
  LeftOut left_out_;
};

/// Increments on their way to an estimator, as one.
class HeldOdometry {
 public:
  /// Takes one more; returns those before it when it does not follow them directly.
  std::optional<OdometryIncrement> add(const OdometryIncrement& increment);
  /// Gives away what is held.
  std::optional<OdometryIncrement> take();
  /// [s]
  [[nodiscard]] double duration() const { return held_ ? held_->duration : 0.0; }

 private:
  std::optional<OdometryIncrement> held_;
};

}  // namespace multipath_localization
