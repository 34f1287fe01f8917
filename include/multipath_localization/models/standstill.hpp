#pragma once

#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// Tells bias and noise of the gyro from a turn on the spot, while the wheels stand.
class Standstill {
 public:
  /// The increment, its yaw rate zero where the robot does not turn: then `standing` holds.
  OdometryIncrement settled(const OdometryIncrement& u);

 private:
  double yaw_rate_ = 0.0;  ///< mean of the last moment [rad/s]
};

/// A whole drive of increments, in order, each settled.
std::vector<OdometryIncrement> settled(const std::vector<OdometryIncrement>& drive);

}  // namespace multipath_localization
