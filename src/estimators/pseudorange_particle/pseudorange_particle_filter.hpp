#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "estimators/pseudorange_particle/pseudorange_motion.hpp"
#include "filters/particle_set.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/models/pseudorange/inter_system_bias.hpp"
#include "multipath_localization/models/pseudorange/los_subset.hpp"
#include "multipath_localization/models/pseudorange/one_sided_position.hpp"

namespace multipath_localization {

/// What a particle is weighed by, as `likelihood` says.
enum class SubsetLikelihood { kDensity, kDistance };

/// What an epoch is worth, as `tempering` says.
enum class Tempering { kTime, kNone };

/// Decisions about Eqs. (11), (12) of [SUZ].
struct SubsetLikelihoodParameters {
  SubsetLikelihood likelihood = SubsetLikelihood::kDensity;
  double likelihood_sigma = 1.0;
  double outlier_sigma = 100.0;
  Tempering tempering = Tempering::kTime;
  double evidence_rate = 0.2;
  double standing_evidence = 0.1;

  void fields(ParameterVisitor& field);
};

/// By which solution the filter starts, as `start` says.
enum class StartPosition { kRobust, kPlain };

/// Whether a filter that is lost starts again, as `reset` says.
enum class Reset { kRobust, kNever };

/// What satellites are weighed by, as `weighting` says.
enum class SatelliteWeighting { kSignal, kDeclared };

/// How the clocks of constellations hang together, as `constellations` says.
enum class ConstellationClocks { kTied, kSeparate };

struct PseudorangeParticleFilterParameters {
  int particles = 500;
  double ess_fraction = 0.5;
  StartPosition start = StartPosition::kRobust;
  double start_sigma = 8.0;
  Reset reset = Reset::kRobust;
  double restart_rate = 0.05;
  double reset_after = 3.0;
  PointEstimate point_estimate = PointEstimate::kCluster;
  double position_sigma_floor = 0.1;
  SatelliteWeighting weighting = SatelliteWeighting::kSignal;
  ConstellationClocks constellations = ConstellationClocks::kTied;
  double inter_system_sigma = 15.0;
  LosSubsetParameters subset;
  SubsetLikelihoodParameters likelihood;
  PseudorangeMotionParameters motion;
  OneSidedPositionParameters robust;

  void fields(ParameterVisitor& field);
};

/// The filter of [SUZ]: particles over the position, each of which takes for reflected what does not fit it
/// and is weighed by how far the remaining satellites would move it.
///
/// The defaults are repaired. The paper to the letter is clock reference, lower_threshold -20,
/// upper_threshold 10, weighting declared, constellations separate, likelihood distance, outlier_sigma 0,
/// tempering none, start plain, start_sigma 0, reset never, ess_fraction 1, point_estimate mean,
/// doppler_tolerance 0, velocity_follows_odometry false; it prints no value for the thresholds.
///
/// Departs, whatever the options: without Doppler the odometry moves the particles, whose headings are all
/// round the circle at the start. Velocities are those of the last epoch, the first included.
class PseudorangeParticleFilter : public Estimator {
 public:
  PseudorangeParticleFilter(const PseudorangeParticleFilterParameters& parameters, std::uint64_t seed);

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  [[nodiscard]] bool uses(std::size_t kind) const override { return kind == kEpochKind; }
  Innovation update(const Measurement& z) override;
  /// `shadow_probability` is the share of the satellites that are taken for reflected.
  [[nodiscard]] PoseEstimate estimate() const override;
  /// At most 2000, evenly chosen.
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  /// One epoch made ready.
  struct Sky {
    std::vector<SatelliteObservation> observations;
    std::vector<double> weights;
    Eigen::Vector2d antenna_in_base;
    std::optional<PseudorangeSolution> fix;  ///< by itself, the particles apart
  };

  [[nodiscard]] Sky sky_of(const PseudorangeEpoch& epoch) const;
  void start_at(const PosePrior& prior);
  [[nodiscard]] std::optional<PseudorangeSolution> start_fix(const Sky& sky) const;
  Innovation start_at(const Sky& sky);
  void draw_errors();
  void draw_heights(const PseudorangeSolution& fix);
  void draw_near(std::size_t i, const Sky& sky, const PseudorangeSolution& fix, RandomStream& random);

  void forget_velocities();
  Innovation track(const Sky& sky);
  Innovation miss(const Sky& sky);
  bool weigh(const Sky& sky, LosSubset& subset);
  void adopt_velocity(std::size_t i, const Sky& sky, const LosSubset& subset);
  [[nodiscard]] double exponent() const;
  [[nodiscard]] Innovation compare(const Sky& sky, LosSubset& subset) const;
  [[nodiscard]] InterSystemBias corrected_inter_system_bias(const LosSubset& subset) const;
  void resample();
  void restart_some(const Sky& sky);
  void restart_all(const Sky& sky);
  void take_stock();
  void settle();
  [[nodiscard]] Eigen::Vector3d mean_antenna(const Eigen::Vector2d& antenna_in_base) const;
  [[nodiscard]] RandomStream random(std::size_t particle) const;

  PseudorangeParticleFilterParameters parameters_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  double now_ = 0.0;
  OdometryIncrement last_increment_;

  ParticleSet particles_;                  ///< none before the first epoch or prior
  std::vector<PseudorangeParticle> rest_;  ///< of the particles, besides the pose
  bool heights_known_ = false;             ///< not after a start from a prior, which has none
  std::vector<double> weights_;            ///< of the particles, sum 1
  std::vector<double> cluster_;            ///< the same within the dominant cluster, 0 outside
  InterSystemBias inter_system_bias_;
  double evidence_time_ = 0.0;  ///< since the last epoch, standing counted in part [s]
  double time_since_epoch_ = 0.0;
  std::optional<double> lost_since_;  ///< the last epoch that gave some particle a subset [s]
  double excluded_share_ = 0.0;
  double effective_sample_size_ = 1.0;
};

}  // namespace multipath_localization
