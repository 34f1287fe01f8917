#pragma once

#include <array>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/pseudorange_belief.hpp"
#include "multipath_localization/models/satellite_mixture.hpp"

namespace multipath_localization {

/// How far single measurements and their repetition are believed.
struct RangeErrorParameters {
  double range_sigma = 2.0;
  double range_correlation_time = 1.0;
  double evidence_time = 30.0;
  double mode_time = 20.0;
  double range_rate_sigma = 0.3;
  double range_rate_correlation_time = 1.0;
  double clock_jump = 30.0;
  SatelliteMixtureParameters mixture;

  void fields(ParameterVisitor& field);
};

/// One satellite of an epoch with its place in the state.
struct SlottedObservation {
  SatelliteObservation observation;
  int bias_slot = 0;
  int offset_slot = -1;  ///< -1: of GPS, whose clock is the reference
  double prior = 0.5;    ///< of LOS
  double delay = 40.0;   ///< mean of NLOS [m]
};

/// An epoch as all hypotheses see it.
struct SlottedEpoch {
  std::vector<SlottedObservation> satellites;
  Eigen::Vector2d antenna_in_base = Eigen::Vector2d::Zero();
  double age = 0.0;             ///< of the measurement [s]
  double duration = 0.0;        ///< since the last epoch [s]
  double information = 0.0;     ///< seconds of independent data it adds: less than `duration` at rest
  double bias_variance = 16.0;  ///< of a satellite's bias in line of sight, before all data [m^2]
  double speed = 0.0;           ///< of the odometry now [m/s]
  double lateral_speed = 0.0;   ///< likewise [m/s]
  double yaw_rate = 0.0;        ///< likewise [rad/s]
};

/// One EKF of the bank, with a two-state Markov chain LOS / NLOS for each satellite.
struct PseudorangeHypothesis {
  PseudorangeBelief belief;
  std::array<double, SatelliteSlots::kCapacity>
      chain{};  ///< probability of LOS by slot; negative: never seen
  double log_weight = 0.0;
  double line_of_sight_share = 1.0;  ///< of the last epoch's satellites

  void append(double variance);
  void remove(int slot);

  /// Weighs an epoch, satellite by satellite: evidence for the hypothesis and for LOS, then the update.
  void update(const SlottedEpoch& epoch, const RangeErrorParameters& errors);

 private:
  /// How a range compares with what was expected in line of sight.
  struct Residual {
    double innovation;
    double HPHt;
    const PseudorangeBelief::Vector& PHt;
    double prior;  ///< of LOS
  };

  void reopen_clock(const SlottedEpoch& epoch, const RangeErrorParameters& errors);
  double update(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                const RangeErrorParameters& errors);
  [[nodiscard]] double evidence(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                                const RangeErrorParameters& errors, const Residual& residual) const;
  void update_rate(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                   const RangeErrorParameters& errors, double probability);
};

}  // namespace multipath_localization
