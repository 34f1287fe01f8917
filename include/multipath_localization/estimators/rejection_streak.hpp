#pragma once

#include <optional>

namespace multipath_localization {

/// How long a gate has refused measurement after measurement. A rejection ages: those further apart than
/// `kLongestPause` do not make a streak, so that two outliers with silence between them open no gate.
class RejectionStreak {
 public:
  static constexpr double kLongestPause = 2.0;  ///< [s]

  /// Counts a rejection at `now` [s] and gives the time since the first of the streak [s].
  double add(double now) {
    if (!last_ || now - *last_ > kLongestPause) first_ = now;
    last_ = now;
    return now - first_;
  }

  /// A measurement has passed.
  void end() { last_.reset(); }

 private:
  double first_ = 0.0;  ///< counts only with `last_`
  std::optional<double> last_;
};

}  // namespace multipath_localization
