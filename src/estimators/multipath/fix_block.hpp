#pragma once

#include <cstddef>
#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization::multipath {

/// Fixes of about a second as one: what a receiver says more often than that it hardly says anew.
///
/// Each is taken back to the base of now, so that their mean is a fix of now with the mean of where the
/// antenna was as its lever arm. Those far from the median of the others do not count.
class FixBlock {
 public:
  /// The base has moved on by that, in its own frame.
  void move(const Pose2& step);

  void add(const GnssFix& fix) { fixes_.push_back(fix); }

  [[nodiscard]] bool empty() const { return fixes_.empty(); }
  [[nodiscard]] std::size_t size() const { return fixes_.size(); }

  /// The fixes as one, those that agree by a heading of `yaw` [rad]; forgets them. At least one has to be
  /// there.
  GnssFix take(double yaw);

 private:
  std::vector<GnssFix> fixes_;
};

}  // namespace multipath_localization::multipath
