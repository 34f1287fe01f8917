#pragma once

#include <cstdint>
#include <optional>

#include "estimators/nishida/bias_filter.hpp"
#include "estimators/nishida/fix_heading.hpp"
#include "models/fix/gnss_likelihood.hpp"
#include "models/motion/steering_motion.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/filters/kld_sampling.hpp"
#include "multipath_localization/models/fix/gnss_bias.hpp"
#include "simd/particle_cloud.hpp"

namespace multipath_localization {

/// What weight a particle drawn on the ring gets, as `ring_weight` says.
enum class RingWeight { kDeviation, kPrinted };

/// Where a fix in shadow puts the robot, as `shadow_place` says.
enum class ShadowPlace { kRing, kVector };

/// Decisions about Eqs. (22)-(26), (32), (33) of [NIS]: what the method adds to a conventional particle
/// filter.
struct RingParameters {
  double ring_fraction = 0.05;
  RingWeight ring_weight = RingWeight::kDeviation;
  ShadowPlace shadow_place = ShadowPlace::kRing;
  double shadow_weight = 0.5;

  void fields(ParameterVisitor& field);
};

/// What the particles of the next step are moved from, as `propagate_from` says.
enum class PropagateFrom { kParticles, kEstimate };

/// Everything that the particle filters of [NIS] have in common.
struct FixParticleFilterParameters {
  KldSamplingParameters sampling;
  double ess_threshold = 5.0;
  PropagateFrom propagate_from = PropagateFrom::kParticles;
  PointEstimate point_estimate = PointEstimate::kCluster;
  double start_sigma = 1.0;
  double position_sigma_floor = 0.1;
  SteeringNoiseParameters motion;
  GnssLikelihoodParameters likelihood;
  FixHeadingParameters heading;
  GnssBiasParameters bias;
  RingParameters ring;

  /// Those that do not concern the ring, the shadow or the bias.
  void common_fields(ParameterVisitor& field);
};

/// Particles over x, y, yaw, moved by odometry and weighed by fixes: [NIS] section 3, Eqs. (3)-(35),
/// (39)-(43), and with neither ring nor shadow Eqs. (46), (47).
///
/// Started without a prior, positions lie round the first fix and headings are uniform. Ring sampling waits
/// until the estimate is aligned: the ring stands round the estimate, which has no heading to give before.
class FixParticleFilter : public Estimator {
 public:
  FixParticleFilter(const FixParticleFilterParameters& parameters, std::uint64_t seed,
                    InstructionSet set = best_instruction_set());

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  Innovation update(const Measurement& z) override;
  [[nodiscard]] PoseEstimate estimate() const override { return estimate_; }
  /// At most 2000, evenly chosen.
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  void start_at(const PosePrior& prior);
  void start_at(const GnssFix& fix);
  void begin_tracking();
  [[nodiscard]] Innovation compare(const GnssFix& fix) const;
  void sample_ring(double radius, const FixSigmas& sigma);
  void take_stock();
  void describe(const PoseSums& sums, const Pose2& reference);
  void resample();
  [[nodiscard]] std::size_t needed_particles();

  FixParticleFilterParameters parameters_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  FixCheck fix_check_;
  BiasFilter bias_filter_;
  FixHeading heading_;
  double now_ = 0.0;
  double last_fix_ = 0.0;

  ParticleCloud particles_;               ///< labelled by the shadow's share of their likelihood
  std::vector<std::uint32_t> ancestors_;  ///< of the last resampling
  OccupiedBins bins_;
  double cluster_reach_ = 0.0;        ///< [m]
  bool particles_are_fresh_ = false;  ///< from an update, not yet moved
  Pose2 predicted_;                   ///< f(x_est, u) since the last update
  PoseEstimate estimate_;
};

}  // namespace multipath_localization
