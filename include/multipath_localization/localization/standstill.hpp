#pragma once

#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// Tells bias and noise of the gyro from a turn on the spot, and noise of the lateral speed from a way
/// sideways, while the base does not roll forwards or backwards: neither now nor on average over the last
/// moment, as between two ticks of an encoder that is read often.
class Standstill {
 public:
  /// The increment, yaw rate and lateral speed zero where the robot neither turns nor moves sideways: then
  /// `standing` holds.
  OdometryIncrement settled(const OdometryIncrement& u);

  /// Whether that held for the last increment. One of no motion between two ticks of an encoder is no rest.
  [[nodiscard]] bool at_rest() const { return at_rest_; }

 private:
  double speed_ = 0.0;          ///< mean of the last moment [m/s]
  double yaw_rate_ = 0.0;       ///< likewise [rad/s]
  double lateral_speed_ = 0.0;  ///< likewise [m/s]
  bool at_rest_ = false;
};

/// A whole drive of increments, in order, each settled.
std::vector<OdometryIncrement> settled(const std::vector<OdometryIncrement>& drive);

}  // namespace multipath_localization
