#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "estimators/pseudorange_particle/pseudorange_motion.hpp"
#include "estimators/pseudorange_particle/pseudorange_particle_filter_parameters.hpp"
#include "filters/particle_set.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/pseudorange/los_subset.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"

namespace multipath_localization {

/// One epoch made ready.
struct PreparedEpoch {
  std::vector<SatelliteObservation> observations;
  std::vector<double> weights;             ///< of these [1/m^2]
  Eigen::Vector2d antenna_in_base;         ///< [m]
  std::optional<PseudorangeSolution> fix;  ///< by itself, the particles apart
};

/// The particles of the pseudorange particle filter: drawn, moved, weighed and resampled.
class PseudorangeCloud {
 public:
  PseudorangeCloud(const PseudorangeParticleFilterParameters& parameters, std::uint64_t seed)
      : parameters_(parameters), seed_(seed) {}

  [[nodiscard]] bool empty() const { return particles_.empty(); }
  /// No particles, as at the beginning.
  void clear();

  /// Draws particles from a prior; their heights are not known.
  void start_at(const PosePrior& prior);
  /// Draws particles near a fix, with headings all round.
  void start_near(const PseudorangeSolution& fix, const Eigen::Vector2d& antenna_in_base);
  /// Draws all heights anew by a fix.
  void draw_heights(const PseudorangeSolution& fix);
  /// A few particles try a fix, each with this probability. To be normalised.
  void restart_some(const PseudorangeSolution& fix, const Eigen::Vector2d& antenna_in_base,
                    double probability);
  /// All particles go to a fix, their headings kept.
  void restart_all(const PseudorangeSolution& fix, const Eigen::Vector2d& antenna_in_base);

  /// Moves all over `u`, from the increment `before` it.
  void move(const OdometryIncrement& u, const OdometryIncrement& before);
  /// Whether one moves, by Doppler.
  [[nodiscard]] bool moves() const;
  void forget_velocities();

  /// Eqs. (5)-(12) of [SUZ] for every particle, of which the likelihood counts to the power of `exponent`;
  /// velocities by Doppler as of the increment `u`. False, and nothing changed, when none has a subset.
  bool weigh(const PreparedEpoch& epoch, LosSubset& subset, double exponent, const OdometryIncrement& u);
  /// Takes the velocity that each particle's subset tells by Doppler.
  void adopt_velocities(const PreparedEpoch& epoch, LosSubset& subset, const OdometryIncrement& u);
  /// Normalises the weights and finds the dominant cluster.
  void take_stock();
  /// Resamples where weights have become uneven.
  void resample_if_uneven();

  /// Mean of the dominant cluster, in map [m].
  [[nodiscard]] Eigen::Vector3d mean_antenna(const Eigen::Vector2d& antenna_in_base) const;
  /// Of the dominant cluster; without stamp.
  [[nodiscard]] PoseEstimate estimate() const;
  /// At most 2000, evenly chosen.
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const;

 private:
  void draw_errors();
  /// Puts a particle near a fix, its heading kept.
  void draw_near(std::size_t i, const PseudorangeSolution& fix, const Eigen::Vector2d& antenna_in_base,
                 RandomStream& random);
  void adopt_velocity(std::size_t i, const PreparedEpoch& epoch, const LosSubset& subset,
                      const OdometryIncrement& u);
  [[nodiscard]] RandomStream random(std::size_t particle) const {
    return {seed_, step_, static_cast<std::uint32_t>(particle)};
  }

  PseudorangeParticleFilterParameters parameters_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  ParticleSet particles_;
  std::vector<PseudorangeParticle> rest_;  ///< of the particles, besides the pose
  std::vector<double> weights_;            ///< of the particles, sum 1
  std::vector<double> cluster_;            ///< the weights within the dominant cluster, 0 outside
  double effective_sample_size_ = 1.0;
};

}  // namespace multipath_localization
