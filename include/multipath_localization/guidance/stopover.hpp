#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace multipath_localization {

/// A wait at a waypoint.
class Stopover {
 public:
  /// Begins to wait for `duration` [s], counted from the first look at it; infinity: until it is ended.
  void begin(double duration) {
    left_ = duration;
    seen_.reset();
  }
  bool end();  ///< whether there was one

  /// Whether it goes on at `now` [s]; NaN is a clock that nobody looked at.
  bool lasts(double now);

  [[nodiscard]] bool by_call() const { return std::isinf(left_); }  ///< it waits to be ended
  [[nodiscard]] std::string status() const;

 private:
  double left_ = 0.0;           ///< [s]
  std::optional<double> seen_;  ///< when it was looked at last [s]
};

}  // namespace multipath_localization
