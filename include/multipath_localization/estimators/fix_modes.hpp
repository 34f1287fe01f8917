#pragma once

#include <array>
#include <optional>

#include "multipath_localization/estimators/belief.hpp"
#include "multipath_localization/models/receiver_class.hpp"
#include "multipath_localization/models/rigid_alignment.hpp"

namespace multipath_localization {

/// The discrete part of a hypothesis.
struct FixMode {
  bool shadow = false;    ///< the fix is biased by reflection or diffraction
  bool noisy = false;     ///< the white noise is the larger one
  bool slipping = false;  ///< the wheels slip
};

/// How a hypothesis may restart from the fixes.
enum class Restart { kNone, kPosition, kHeading };

/// One way the world may have gone since the last fix, as seen by one hypothesis.
struct FixCandidate {
  FixMode mode;
  Restart restart = Restart::kNone;
  bool outlier = false;    ///< the fix says nothing
  bool keeps_bias = true;  ///< bias decays by `bias_factor`; else it starts at zero
  double bias_factor = 1.0;
  double bias_variance = 0.0;  ///< added, or, for a new bias, all of it [m^2]
  double fix_variance = 0.0;   ///< white noise an axis [m^2]
  double prior = 0.0;          ///< probability before the fix is looked at
};

inline constexpr std::size_t kFixCandidates = 8;
using FixCandidates = std::array<FixCandidate, kFixCandidates>;

/// What all hypotheses of one class share at one fix.
struct FixInterval {
  double duration = 0.0;               ///< since the last fix [s]
  double slip_distance = 0.0;          ///< that slipping or locked wheels may have hidden since [m]
  double unseen_variance = 0.0;        ///< of motion at the usual speed that odometry has not told of [m^2]
  bool moving = false;                 ///< more than the noise of a standing robot
  double position_restart_rate = 0.0;  ///< [1/s]
  double heading_restart_rate = 0.0;   ///< [1/s]
  double restart_sigma = 5.0;          ///< of position at a restart [m]
  double slip_end_rate = 1.0;          ///< [1/s]
  std::optional<AlignedHeading> aligned_heading;
};

/// Modes of one receiver class at one fix: their priors, their likelihoods and what they do to a belief.
/// The two modes of Eq. (10) of [NIS], extended by noise level, slip, restart and outlier.
class FixModes {
 public:
  FixModes(const ReceiverClass& receiver, const FixInterval& interval);

  /// Every way on from `mode`.
  [[nodiscard]] FixCandidates candidates(const FixMode& mode, const Belief& belief) const;

  /// Log likelihood of the fix under a candidate.
  [[nodiscard]] double log_likelihood(const FixCandidate& candidate, const FixPrediction& prediction,
                                      double yaw, const Eigen::Vector2d& fix) const;

  /// Carries the belief over to the candidate and corrects it by the fix.
  void apply(const FixCandidate& candidate, const Eigen::Vector2d& fix,
             const Eigen::Vector2d& antenna_in_base, const OdometryNoise& odometry, Belief& belief) const;

 private:
  /// Probabilities of the modes to come.
  struct Transition {
    double shadow = 0.0;
    double noisy_if_open = 0.0;
    double noisy_if_shadow = 0.0;
  };

  [[nodiscard]] FixCandidates always_shadow(const FixMode& mode) const;
  [[nodiscard]] Transition transition(const FixMode& mode) const;
  [[nodiscard]] double slip_probability(const FixMode& mode) const;
  [[nodiscard]] FixCandidate base(const FixMode& from, const FixMode& to) const;
  [[nodiscard]] double heading_restart_probability(const Belief& belief) const;
  [[nodiscard]] Eigen::Matrix2d extra_position_covariance(const FixCandidate& candidate, double yaw) const;

  const ReceiverClass& receiver_;
  const FixInterval& interval_;
};

}  // namespace multipath_localization
