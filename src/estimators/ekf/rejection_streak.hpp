#pragma once

#include <algorithm>
#include <optional>

namespace multipath_localization {

/// How long a gate has refused measurement after measurement. A silence between them counts `kLongestPause`
/// at most: two outliers with silence between them open no gate, and slow measurements do in the end.
class RejectionStreak {
 public:
  static constexpr double kLongestPause = 2.0;  ///< [s]

  /// Counts a rejection at `now` [s] and gives how long the streak has lasted [s].
  double add(double now) {
    lasted_ = last_ ? lasted_ + std::min(now - *last_, kLongestPause) : 0.0;
    last_ = now;
    return lasted_;
  }

  /// A measurement has passed.
  void end() { last_.reset(); }

 private:
  double lasted_ = 0.0;  ///< counts only with `last_`
  std::optional<double> last_;
};

}  // namespace multipath_localization
