#pragma once

#include <cstddef>
#include <vector>

#include "multipath_localization/core/pose.hpp"
#include "simd/pose_moments.hpp"

namespace multipath_localization {

/// Weighted poses, as a structure of arrays of one length [m, rad]. Weights are kept as logarithms, up to a
/// common constant until normalised, so that likelihoods far from every particle do not underflow to zero.
struct ParticleSet {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> yaw;
  std::vector<double> log_weight;

  ParticleSet() = default;
  /// `size` particles at the origin, equally weighted.
  explicit ParticleSet(std::size_t size);

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool empty() const { return x.empty(); }
  [[nodiscard]] Pose2 pose(std::size_t i) const { return {x[i], y[i], yaw[i]}; }
  void set_pose(std::size_t i, const Pose2& pose);

  /// The particles at `ancestors`, equally weighted: Eqs. (40), (41) of [NIS].
  [[nodiscard]] ParticleSet selected(const std::vector<std::size_t>& ancestors) const;
};

/// Scales logarithmic weights so that the weights sum to 1, Eq. (34) of [NIS]. NaN counts as no weight. When
/// no particle has any weight all become equal, and the answer is false: the measurement excluded every
/// particle.
bool normalise(std::vector<double>& log_weights);

/// The weights of normalised logarithms.
std::vector<double> weights_of(const std::vector<double>& log_weights);

/// 1 / sum w^2 of weights that sum to 1, Eq. (39) of [NIS]: 1 .. size.
double effective_sample_size(const std::vector<double>& weights);

/// Eq. (35) of [NIS] and its covariance. Weights need not sum to 1 (those of a cluster do not), their sum has
/// to be positive.
PoseMoments moments(const ParticleSet& particles, const std::vector<double>& weights);

/// The weights within the dominant cluster, 0 outside; their sum is the cluster's probability mass. A cluster
/// is all that lies within `distance` [m] and `turn` [rad] of one particle; the dominant one is the heaviest
/// of those round 24 particles that stand at equal steps of the cumulated weight, so that every mode of mass
/// above 1/24 is tried.
std::vector<double> dominant_cluster(const ParticleSet& particles, const std::vector<double>& weights,
                                     double distance, double turn);

}  // namespace multipath_localization
