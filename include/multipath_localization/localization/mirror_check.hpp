#pragma once

#include <Eigen/Core>
#include <deque>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// Tells odometry that is mirrored, as a driver gives it that has y to the right or axes of NED: over the
/// last metres its way fits that of the fixes when it is turned over, and not as it is. On a straight way
/// both fit, among buildings neither may: what was told before holds then.
class MirrorCheck {
 public:
  void clear();
  void add(const OdometryIncrement& u);
  /// Takes a fix of an antenna that is where dead reckoning is now.
  void add(const GnssFix& fix);

  [[nodiscard]] bool mirrored() const { return mirrored_; }

 private:
  struct Pair {
    double driven;  ///< [m]
    Eigen::Vector2d in_odom;
    Eigen::Vector2d in_map;
  };

  void decide();

  Pose2 base_in_odom_;
  double driven_ = 0.0;
  std::deque<Pair> pairs_;
  bool mirrored_ = false;
};

}  // namespace multipath_localization
