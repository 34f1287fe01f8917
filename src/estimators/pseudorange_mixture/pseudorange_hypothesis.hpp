#pragma once

#include <array>

#include "estimators/pseudorange_mixture/motion_law.hpp"
#include "estimators/pseudorange_mixture/pseudorange_kalman_filter.hpp"

namespace multipath_localization {

/// One hypothesis of the bank: a Kalman filter for each law of motion, which interact (Blom and
/// Bar-Shalom 1988): how good the odometry is nobody knows, and it changes.
class PseudorangeHypothesis {
 public:
  /// All filters start from the same belief, the laws as `laws` has them.
  PseudorangeHypothesis(const PseudorangeBelief& belief, const MotionLaws& laws);

  /// Takes over what another has learnt of odometry and receiver, which is the same wherever the robot is.
  void learn_from(const PseudorangeHypothesis& other);

  double log_weight = 0.0;

  void append(double variance);
  void remove(int slot);
  void propagate(const PreintegratedOdometry& odometry, const MotionLaws& laws,
                 const OdometryNoise& odometry_noise, const ReceiverStateNoise& noise,
                 const SatelliteSlots& slots);
  /// Weighs an epoch: evidence for the hypothesis and for its laws, then the update.
  void update(const SlottedEpoch& epoch, const MotionLaws& laws, const RangeErrorParameters& errors);

  /// The planar part, of all laws together.
  [[nodiscard]] Belief planar() const;
  /// Of the most likely law.
  [[nodiscard]] const PseudorangeBelief& likeliest() const { return filters_[best()].belief; }
  [[nodiscard]] double line_of_sight_share() const;  ///< of the last epoch's satellites
  [[nodiscard]] const std::array<double, kMotionLaws>& probabilities() const { return probabilities_; }

 private:
  [[nodiscard]] std::size_t best() const;
  void interact(const MotionLaws::Matrix& transitions);

  std::array<PseudorangeKalmanFilter, kMotionLaws> filters_;  ///< one a law
  std::array<double, kMotionLaws> probabilities_;
};

}  // namespace multipath_localization
