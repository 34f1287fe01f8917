#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// Whether the differences of odometry's poses are its motion: over the last seconds they lead where the
/// twist leads, and this one is no jump. Then they are the better motion of the two: what encoders counted
/// between two messages, and not a sample, a mean or a filter's output of the speed.
class PoseAgreement {
 public:
  /// Of one interval, by the difference of the poses and by the later twist alone. That is right on average
  /// where messages come in bursts as well.
  bool agrees(const OdometryIncrement& by_pose, const OdometryIncrement& by_twist);
  void clear() { *this = PoseAgreement(); }

 private:
  Eigen::Vector2d way_apart_ = Eigen::Vector2d::Zero();  ///< way by pose less way by twist [m]
  double turn_apart_ = 0.0;                              ///< likewise [rad]
  double way_ = 0.0;                                     ///< [m]
  double turn_ = 0.0;                                    ///< whatever its sign [rad]
  double time_ = 0.0;                                    ///< looked at [s]
};

}  // namespace multipath_localization
