#pragma once

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization::multipath {

/// What all fixes of a drive are off by alike where the receiver gets no corrections: a position is known as
/// well as corrections make it, and for a while after they are gone.
class CommonError {
 public:
  /// The first fix, of a receiver that is off by `sigma` without corrections [m].
  void begin(FixStatus status, double sigma) { go_on(status, kMemory, sigma); }
  /// A fix `duration` [s] after the last one.
  void go_on(FixStatus status, double duration, double sigma);

  [[nodiscard]] double variance() const { return variance_; }  ///< of an axis [m^2]

 private:
  static constexpr double kMemory = 60.0;  ///< of odometry for a position that corrected fixes gave [s]

  double variance_ = 0.0;
};

}  // namespace multipath_localization::multipath
