#pragma once

#include "estimators/multipath/hypothesis_cloud.hpp"

namespace multipath_localization::multipath {

/// A second cloud, started afresh from the fixes, in case the first one is wrong in a way that none of its
/// hypotheses covers: a heading lost while the wheels failed in a shadow, a start among reflections. It is
/// taken in once it foretells the fixes that much better, equation (17).
class Rival {
 public:
  Rival(CloudSettings settings, std::uint64_t seed);

  /// Moves on by the odometry that moves the first cloud.
  void propagate(const OdometrySum& odometry);

  /// Weighs a fix that `cloud` has weighed already and whose probability density there was
  /// exp(`log_density`) [1/m^2]; joins `cloud` when it has become worth it.
  void weigh(const Sighting& sighting, double log_density, HypothesisCloud& cloud);

 private:
  void start(const Sighting& sighting, double log_density, const HypothesisCloud& cloud);
  [[nodiscard]] bool pointless(const HypothesisCloud& cloud) const;

  HypothesisCloud cloud_;
  double log_odds_ = 0.0;  ///< of being right against the first cloud's
  double age_ = 0.0;       ///< time driven since the start [s]
};

}  // namespace multipath_localization::multipath
