#pragma once

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization::multipath {

/// How long the wheels have turned, where an encoder may tell of that one tick at a time: between two
/// increments that move and are near to each other they have turned too.
class MovingTime {
 public:
  /// Takes the next increment and returns the time [s] in which, as it shows, the wheels have turned since
  /// the increment before it that moved.
  double add(const OdometryIncrement& u);

 private:
  double since_moving_ = 0.0;  ///< until the end of the last increment [s]
};

}  // namespace multipath_localization::multipath
