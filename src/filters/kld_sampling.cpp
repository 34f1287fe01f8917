#include "multipath_localization/filters/kld_sampling.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

/// Number of a cell, folded into 24 bits: bins that many cells apart count as one.
std::uint64_t cell(double value, double size) {
  const double folded = std::fmod(std::floor(value / size), 0x1p23);
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(folded)) & 0xFFFFFFU;
}

}  // namespace

void KldSamplingParameters::fields(ParameterVisitor& field) {
  field("min_particles", min_particles, {1, 100000}, "1", "M at least; equal to max_particles: M, fixed");
  field("max_particles", max_particles, {1, 100000}, "1",
        "M at most, and at the start; in between, KLD sampling decides whenever particles are resampled");
  field("kld_err", kld_err, {1e-4, 1.0}, "1",
        "Kullback-Leibler distance from the true belief that is allowed");
  field("kld_z", kld_z, {0.0, 6.0}, "1",
        "normal quantile of the probability with which it is kept: 2.326 = 99 %, 3 = 99.87 %");
  field("kld_bin_size_xy", kld_bin_size_xy, {0.01, 100.0}, "m",
        "side of the bins that a belief is counted in");
  field("kld_bin_size_yaw", kld_bin_size_yaw, {0.01, kPi}, "rad", "and their size in heading");
}

std::size_t most_particles(const KldSamplingParameters& parameters) {
  return static_cast<std::size_t>(std::max(parameters.min_particles, parameters.max_particles));
}

std::size_t kld_sample_size(std::size_t bins, const KldSamplingParameters& parameters) {
  const auto least = static_cast<std::size_t>(parameters.min_particles);
  if (bins < 2) return least;
  const auto dof = static_cast<double>(bins - 1);
  const double spread = 2.0 / (9.0 * dof);
  const double size =
      dof / (2.0 * parameters.kld_err) * std::pow(1.0 - spread + std::sqrt(spread) * parameters.kld_z, 3);
  return std::clamp(static_cast<std::size_t>(std::ceil(std::min(size, 1e9))), least,
                    most_particles(parameters));
}

void OccupiedBins::add(const Pose2& pose) {
  bins_.push_back(cell(pose.x, parameters_.kld_bin_size_xy) << 40U |
                  cell(pose.y, parameters_.kld_bin_size_xy) << 16U |
                  (cell(wrap_angle(pose.yaw), parameters_.kld_bin_size_yaw) & 0xFFFFU));
}

std::size_t OccupiedBins::count() {
  std::sort(bins_.begin(), bins_.end());
  bins_.erase(std::unique(bins_.begin(), bins_.end()), bins_.end());
  return bins_.size();
}

}  // namespace multipath_localization
