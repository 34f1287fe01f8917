#pragma once

#include <array>
#include <vector>

#include "estimators/pseudorange_mixture/error_scales.hpp"
#include "estimators/pseudorange_mixture/pseudorange_belief.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/models/pseudorange/satellite_mixture.hpp"

namespace multipath_localization {

/// How far single measurements and their repetition are believed.
struct RangeErrorParameters {
  double range_sigma = 2.0;
  double range_correlation_time = 3.0;
  double evidence_time = 30.0;
  double mode_time = 20.0;
  double range_rate_sigma = 0.3;
  SatelliteMixtureParameters mixture;

  void fields(ParameterVisitor& field);
};

/// Range rates closer in time than this say the same, whatever the rate of the receiver [s].
inline constexpr double kRangeRateTime = 1.0;

/// One satellite of an epoch with its place in the state.
struct SlottedObservation {
  SatelliteObservation observation;
  int bias_slot = 0;
  int offset_slot = -1;  ///< -1: of GPS, whose clock is the reference
  double prior = 0.5;    ///< of LOS
  double delay = 40.0;   ///< mean of NLOS [m]
  double sigma = 2.0;    ///< of the range in LOS [m]
  double share = 1.0;    ///< of one count, that it is worth as evidence for the place
};

/// 1 sigma of a range in line of sight [m] by its C/N0 against the receiver's usual one: a code loop's noise
/// goes with the root of the noise density over the carrier.
double line_of_sight_sigma(const SatelliteObservation& observation, const RangeErrorParameters& errors);

/// An epoch as all hypotheses see it.
struct SlottedEpoch {
  std::vector<SlottedObservation> satellites;
  Eigen::Vector2d antenna_in_base = Eigen::Vector2d::Zero();
  double age = 0.0;             ///< of the measurement [s]
  double duration = 0.0;        ///< since the last epoch [s]
  double information = 0.0;     ///< seconds of independent data it adds: less than `duration` at rest
  double bias_variance = 16.0;  ///< of a satellite's bias in line of sight, before all data [m^2]
  bool has_rates = false;       ///< whether there are range rates
  bool wheels = true;           ///< whether the odometry is more than these range rates
  double speed = 0.0;           ///< of the odometry now [m/s]
  double lateral_speed = 0.0;   ///< likewise [m/s]
  double yaw_rate = 0.0;        ///< likewise [rad/s]
};

/// What an epoch says for a filter: log likelihoods, one of each satellite added up.
struct EpochEvidence {
  double place = 0.0;   ///< of the ranges, a satellite's bias charged again as long as it lasts, tempered
  double ranges = 0.0;  ///< of the ranges as they were foretold
  double rates = 0.0;   ///< of the range rates
};

/// An extended Kalman filter under one law of motion, with a two-state Markov chain LOS / NLOS for each
/// satellite.
struct PseudorangeKalmanFilter {
  explicit PseudorangeKalmanFilter(const PseudorangeBelief& start) : belief(start) { chain.fill(-1.0); }

  PseudorangeBelief belief;
  std::array<double, SatelliteSlots::kCapacity> chain;  ///< probability of LOS by slot; negative: never seen
  double line_of_sight_share = 1.0;                     ///< of the last epoch's satellites
  ErrorScales scales;

  void append(double variance);
  void remove(int slot);

  void propagate(const PreintegratedOdometry& odometry, const MotionLaw& law,
                 const OdometryNoise& odometry_noise, const ReceiverStateNoise& noise,
                 const SatelliteSlots& slots);

  /// Takes an epoch in, satellite by satellite, and tells what it says for this filter.
  EpochEvidence update(const SlottedEpoch& epoch, const RangeErrorParameters& errors);

  /// Becomes the mixture of itself and another filter of `share` (0, 1) of both weights, as one Gaussian.
  void mix(const PseudorangeKalmanFilter& other, double share);

 private:
  /// How a range compares with what was expected in line of sight.
  struct Residual {
    double innovation;
    double HPHt;
    const PseudorangeBelief::Vector& PHt;
    double prior;  ///< of LOS
  };

  void reopen_clock(const SlottedEpoch& epoch);
  /// Of one satellite; adds to the evidence and gives its probability of LOS.
  double update_range(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                      const RangeErrorParameters& errors, EpochEvidence& evidence);
  [[nodiscard]] double evidence_of_place(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                                         const Residual& residual) const;
  /// Gives the log likelihood of the range rate.
  double update_rate(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                     const RangeErrorParameters& errors, double line_of_sight);
  void learn_biases(const SlottedEpoch& epoch);
  /// Without wheels the robot points where it goes, and cars do not reverse fast.
  void follow_course();
};

}  // namespace multipath_localization
