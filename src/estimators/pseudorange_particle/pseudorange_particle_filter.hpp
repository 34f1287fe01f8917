#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "estimators/pseudorange_particle/pseudorange_cloud.hpp"
#include "estimators/pseudorange_particle/pseudorange_particle_filter_parameters.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/models/pseudorange/inter_system_bias.hpp"

namespace multipath_localization {

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
  [[nodiscard]] PreparedEpoch prepared(const PseudorangeEpoch& epoch) const;
  Innovation begin(const PreparedEpoch& epoch);
  Innovation track(const PreparedEpoch& epoch);
  /// No particle has a subset, of which [SUZ] says nothing.
  Innovation miss(const PreparedEpoch& epoch);
  /// The epoch has been used.
  void settle();
  /// The share of an epoch's likelihood that counts.
  [[nodiscard]] double exponent() const;
  /// The mean of the particles against the position that its subset speaks for.
  [[nodiscard]] Innovation compare(const PreparedEpoch& epoch, LosSubset& subset) const;
  [[nodiscard]] InterSystemBias corrected_inter_system_bias(const LosSubset& subset) const;

  PseudorangeParticleFilterParameters parameters_;
  double now_ = 0.0;
  OdometryIncrement last_increment_;
  PseudorangeCloud cloud_;      ///< none before the first epoch or prior
  bool heights_known_ = false;  ///< not after a start from a prior, which has none
  InterSystemBias inter_system_bias_;
  double evidence_time_ = 0.0;  ///< since the last epoch, standing counted in part [s]
  double time_since_epoch_ = 0.0;
  std::optional<double> lost_since_;  ///< the last epoch that gave some particle a subset [s]
  double excluded_share_ = 0.0;
};

}  // namespace multipath_localization
