#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/dominant_cluster.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/estimators/fix_check.hpp"
#include "multipath_localization/estimators/hypothesis_banks.hpp"
#include "multipath_localization/estimators/odometry_jump.hpp"
#include "multipath_localization/estimators/steady_bias.hpp"

namespace multipath_localization {

struct MultipathParticleFilterParameters {
  int particles = 400;
  double ess_fraction = 0.5;
  double class_floor = 0.05;
  double class_evidence_time = 2.0;
  double restart_sigma = 5.0;
  double largest_bias = 20.0;
  double doubtful_sigma = 10.0;
  double heading_restart_rate = 0.001;
  double slip_end_rate = 1.0;
  double alignment_length = 12.0;
  double alignment_variance_floor = 0.02;
  double confirm_probability = 0.8;
  double confirm_distance = 12.0;
  bool confirmed_start = false;
  double sigma_factor = 1.5;
  double position_sigma_floor = 0.05;
  double unconfirmed_sigma = 2.0;
  OdometryNoise odometry;
  OdometryJumpParameters odometry_jump;
  SteadyBiasParameters steady_bias;
  ReceiverClasses classes;

  void fields(ParameterVisitor& field);
  /// Those of them that may change while the filter runs.
  void tunable(ParameterVisitor& field);
};

/// The default estimator: position from fixes that may be reflected, and wheel odometry.
///
/// Goes on from [NIS]: the time-varying bias of Eq. (10) is tracked by a Kalman filter, but as a vector and
/// within each particle, jointly with the pose and the constants of the odometry (Rao-Blackwellisation); what
/// a particle samples is the discrete part: open sky or shadow, quiet or noisy, slip, and the class of the
/// receiver's surroundings. Particles start with headings all round the circle. The pose published is that of
/// the dominant cluster. `aligned` turns true when the fixes of an open sky, or a canyon with a settled
/// heading, confirmed it.
class MultipathParticleFilter : public Estimator {
 public:
  /// Throws ParameterError where no receiver class can be.
  MultipathParticleFilter(const MultipathParticleFilterParameters& parameters, std::uint64_t seed);

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  Innovation update(const Measurement& z) override;
  void tune(ParameterVisitor& field) override;
  [[nodiscard]] PoseEstimate estimate() const override;
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  /// Spreads the hypotheses over classes, modes and headings; `place` sets the rest of each.
  template <class Place>
  void spread(Place place);
  void start_at(const GnssFix& fix);
  void start_at(const PosePrior& prior);

  /// From where the last fix was, by odometry [m]: jitter leads nowhere.
  [[nodiscard]] double way_since_fix() const { return since_fix_.position().norm(); }
  [[nodiscard]] bool moving() const;
  void flush_odometry();
  void weigh(const GnssFix& fix);
  /// Samples the mode of every hypothesis and corrects it by the fix; gives the log likelihood of each.
  std::vector<double> sample_modes(const GnssFix& fix, double duration);
  [[nodiscard]] FixInterval interval(const ReceiverClass& receiver, double duration) const;
  /// Lets the class change, as it does within `duration` [s], and where the wheels are suspected.
  void change_classes(double duration, bool suspect);

  /// Of what holds for some of the particles.
  template <class Property>
  [[nodiscard]] double probability(Property property) const;
  /// Takes note of a jump of the odometry, `duration` [s] after the last time; tells whether there was one.
  bool suspect_wheels(double duration);
  /// Without a fix: the odometry alone can show that the wheels fail, and nothing shows a slip.
  void doubt_odometry();
  /// Of position, where the wheels have failed: the way at the usual speed since the last fix that
  /// `doubt_odometry` has not counted yet, squared [m^2].
  [[nodiscard]] double unseen_variance() const;
  [[nodiscard]] double doubtful_bias() const;
  [[nodiscard]] bool scattered() const;
  void unconfirm();
  void update_confirmation();
  /// Where the bias has been steady for too long, puts the hypotheses where the fixes are.
  void doubt_steady_bias(double moving_time);

  void refresh_cluster();
  [[nodiscard]] Innovation innovation(const GnssFix& fix) const;
  [[nodiscard]] Belief current_belief() const;

  MultipathParticleFilterParameters parameters_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  PerClass prior_;  ///< of the receiver classes

  std::vector<BeliefParticle> particles_;  ///< none before the first fix or prior
  DominantCluster cluster_;                ///< of the particles as they are
  PerClass class_probability_{};
  double effective_sample_size_ = 0.0;

  PreintegratedOdometry odometry_;  ///< since the particles were last moved
  OdometryJump odometry_jump_;
  SteadyBias steady_bias_;
  RigidAlignment alignment_;
  FixCheck fix_check_;
  double now_ = 0.0;
  double last_fix_ = 0.0;
  double doubted_until_ = 0.0;       ///< the last fix, or `doubt_odometry` after it [s]
  double distance_since_fix_ = 0.0;  ///< along the way [m]
  Pose2 since_fix_;                  ///< the base where it was at the last fix, by odometry
  double usual_speed_ = 0.0;         ///< of the last seconds in which the wheels turned [m/s]
  double suspected_for_ = 0.0;       ///< time left in which standing wheels may be locked [s]
  double confirmed_over_ = 0.0;      ///< distance moved under an open sky that explains the fixes [m]
  double settled_over_ = 0.0;        ///< distance moved in a canyon with one heading left [m]
  bool confirmed_ = false;
};

}  // namespace multipath_localization
