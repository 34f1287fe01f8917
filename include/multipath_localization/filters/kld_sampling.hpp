#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// How many particles a belief needs, by KLD sampling (D. Fox, Int. J. Robotics Research 22, 2003). Where
/// both numbers are one the count is fixed.
struct KldSamplingParameters {
  int min_particles = 1000;
  int max_particles = 1000;
  double kld_err = 0.05;
  double kld_z = 2.326;
  double kld_bin_size_xy = 0.5;
  double kld_bin_size_yaw = 0.1745;

  void fields(ParameterVisitor& field);
};

/// max_particles, but not below min_particles.
std::size_t most_particles(const KldSamplingParameters& parameters);

/// Least number of particles with which the error of the belief over `bins` bins, as Kullback-Leibler
/// distance, stays below `kld_err` with the probability that belongs to `kld_z`: by the approximation of
/// Wilson and Hilferty to the chi-square quantile. Held between the least and the most; the least for a
/// single bin.
std::size_t kld_sample_size(std::size_t bins, const KldSamplingParameters& parameters);

/// Counts the bins of a grid over x, y, yaw that poses fall into.
class OccupiedBins {
 public:
  explicit OccupiedBins(const KldSamplingParameters& parameters) : parameters_(parameters) {}

  void clear() { bins_.clear(); }
  void add(const Pose2& pose);
  std::size_t count();

 private:
  KldSamplingParameters parameters_;
  std::vector<std::uint64_t> bins_;
};

}  // namespace multipath_localization
