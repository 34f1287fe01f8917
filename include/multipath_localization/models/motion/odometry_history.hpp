#pragma once

#include <deque>
#include <optional>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// The odometry of the last seconds, so that a late measurement counts at its own stamp.
class OdometryHistory {
 public:
  /// Keeps increments for `length` seconds.
  explicit OdometryHistory(double length) : length_(length) {}

  /// Appends an increment; stamps must not decrease.
  void add(const OdometryIncrement& increment);
  void clear() { nodes_.clear(); }

  /// Pose of the base at `stamp` in the base frame of now (the last increment's end). Nothing when `stamp`
  /// is later than now or older than the history.
  [[nodiscard]] std::optional<Pose2> base_then_in_base_now(double stamp) const;

  [[nodiscard]] bool empty() const { return nodes_.empty(); }

 private:
  struct Node {
    double stamp;
    Pose2 base_in_odom;
    OdometryIncrement increment;  ///< that led here
  };

  double length_;
  std::deque<Node> nodes_;
};

}  // namespace multipath_localization
