#pragma once

#include <optional>

namespace multipath_localization {

/// Whether a mixture is to be believed: one cluster has held nearly all weight for some way, and as many
/// satellites seem to be in line of sight as their signals promise.
class MixtureAlignment {
 public:
  /// Starts anew, at a prior with that variance of the yaw [rad^2] or from nothing.
  void restart(const std::optional<double>& yaw_variance);

  /// So many satellites were found in line of sight of those `expected`, over `duration` [s].
  void compare(double found, double expected, double duration);

  /// The dominant cluster has this mass and variance of the yaw [rad^2], `moved` [m] after the last one.
  void update(double mass, double yaw_variance, double moved);

  [[nodiscard]] bool aligned() const { return aligned_; }
  /// Whether far fewer satellites seem to be in line of sight than their signals promise.
  [[nodiscard]] bool in_doubt() const { return agreement_ < kLeastAgreement; }

 private:
  static constexpr double kLeastAgreement = 0.4;  ///< C/N0 and elevation promise more than there are by half

  double settled_over_ = 0.0;  ///< distance with one cluster left [m]
  double agreement_ = 1.0;     ///< found over expected, of some seconds
  bool aligned_ = false;
};

}  // namespace multipath_localization
