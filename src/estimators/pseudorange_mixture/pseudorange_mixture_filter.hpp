#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "estimators/pseudorange_mixture/mixture_alignment.hpp"
#include "estimators/pseudorange_mixture/pseudorange_bank.hpp"
#include "estimators/pseudorange_mixture/pseudorange_hypothesis.hpp"
#include "estimators/pseudorange_mixture/pseudorange_seeding.hpp"
#include "estimators/pseudorange_mixture/satellite_slots.hpp"
#include "estimators/pseudorange_mixture/signal_scale.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/estimator.hpp"

namespace multipath_localization {

struct PseudorangeMixtureFilterParameters {
  int hypotheses = 60;
  int subsets = 500;
  double start_sigma = 15.0;
  double sigma_factor = 1.5;
  double uncorrected_sigma = 1.5;
  double position_sigma_floor = 0.3;
  OdometryNoise odometry;
  ReceiverStateNoise receiver;
  RangeErrorParameters errors;

  PseudorangeMixtureFilterParameters() { odometry.gyro_bias_sigma = 0.003; }
  void fields(ParameterVisitor& field);
};

/// Position from the raw pseudoranges of a receiver among buildings, and wheel odometry: start, heading,
/// clock and offsets between constellations unknown.
///
/// Goes on from [SUZ], which decides for each particle which satellites are in line of sight by thresholds on
/// residuals against one reference satellite. Here each hypothesis is a bank of extended Kalman filters, one
/// for each law of how far the odometry can be trusted, over pose, constants of the odometry, height, clock,
/// velocity that the odometry does not see and one bias for each satellite. How large the errors of ranges,
/// range rates and biases are it learns, and C/N0 counts against the receiver's own strong signals. Without
/// wheels, where the motion is that of the range rates, these alone move it. Whether a satellite is in
/// line of sight is a probability: a mixture of a Gaussian and a Gaussian with exponential delay, with a
/// prior from C/N0 and elevation and a memory. Hypotheses start at positions by random subsets of satellites
/// and at headings all round the circle; evidence weighs them, and those that lose are dropped. New ones are
/// tried for ever, with little weight once a cluster has won: a wrong place has to stand against them. When
/// far fewer satellites seem to be in line of sight than their signals promise, the filter is no longer
/// aligned, wherever its weight is.
class PseudorangeMixtureFilter : public Estimator {
 public:
  PseudorangeMixtureFilter(const PseudorangeMixtureFilterParameters& parameters, std::uint64_t seed);

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  [[nodiscard]] bool uses(std::size_t kind) const override { return kind == kEpochKind; }
  Innovation update(const Measurement& z) override;
  [[nodiscard]] PoseEstimate estimate() const override;
  /// Draws from the hypotheses' Gaussians.
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  Innovation weigh(const PseudorangeEpoch& epoch);
  /// Adds `count` hypotheses at random, which share `probability`; at the start they are the first. False
  /// when the epoch does not allow any.
  bool seed(const SlottedEpoch& epoch, int count, double probability);
  /// Tries other places and headings beside those of the bank, when it is time to.
  void reseed(const SlottedEpoch& epoch);
  /// Weight that hypotheses get together which are tried so.
  [[nodiscard]] double reseed_probability() const;
  [[nodiscard]] PseudorangeBelief unknown_belief() const;
  [[nodiscard]] PseudorangeHypothesis hypothesis_at(const PseudorangeSeed& seed, double yaw,
                                                    const Eigen::Vector2d& antenna_in_base,
                                                    const std::optional<ReceiverPrior>& receiver) const;
  [[nodiscard]] std::optional<AntennaPrior> antenna_prior(const Eigen::Vector2d& antenna_in_base) const;
  [[nodiscard]] SlottedEpoch slotted(const PseudorangeEpoch& epoch);
  [[nodiscard]] const MotionLaws& laws() const {
    return last_.from_range_rates ? laws_without_wheels() : laws_of_wheels();
  }
  /// Speed of the robot [m/s] by the odometry of `duration` [s], or by the heaviest hypothesis without one.
  [[nodiscard]] double pace(double duration) const;
  void update_alignment(const SlottedEpoch& epoch);

  PseudorangeMixtureFilterParameters parameters_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;

  PseudorangeBank bank_;    ///< none before the first epoch or prior
  bool has_clock_ = false;  ///< whether an epoch has been used
  SatelliteSlots slots_;
  MixtureAlignment alignment_;
  SignalScale signal_;
  OdometryIncrement last_;
  double last_epoch_ = 0.0;
  double last_seeding_ = 0.0;
  double moved_ = 0.0;  ///< distance since the last epoch [m]
};

}  // namespace multipath_localization
