#pragma once

#include <array>

#include "multipath_localization/core/constellation.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"

namespace multipath_localization {

/// The receiver's clock against each constellation, over that against the first one seen: constants of the
/// receiver that wander slowly, each tracked by a Kalman filter of one state. Knowing them leaves one clock
/// to solve for instead of one per constellation.
class InterSystemBias {
 public:
  /// `sigma`: how far the first value of one can be off [m]; infinity leaves every clock free for ever.
  explicit InterSystemBias(double sigma) : sigma_(sigma) { forget(); }

  void forget();

  /// Takes the first value of each constellation not known yet from the clocks of a solution.
  void adopt(const PseudorangeSolution& solution);

  /// Lets them wander for `duration` [s].
  void wander(double duration);

  /// Corrects by a difference seen, clock - clock of the reference - mean [m], with its variance [m^2].
  void correct(Constellation constellation, double difference, double variance);

  /// Nothing before the first solution.
  [[nodiscard]] std::optional<Constellation> reference() const { return reference_; }

  [[nodiscard]] double mean(Constellation constellation) const;      ///< [m]
  [[nodiscard]] double variance(Constellation constellation) const;  ///< infinite while not known [m^2]

 private:
  double sigma_;
  std::optional<Constellation> reference_;
  std::array<double, kConstellations> mean_{};
  std::array<double, kConstellations> variance_{};
};

}  // namespace multipath_localization
