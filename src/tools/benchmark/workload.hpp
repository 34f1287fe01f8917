#pragma once

#include <cmath>
#include <cstddef>

#include "estimators/nishida/nishida_particle_filter.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization::workload {

/// What all filters are given: a circle at 1 m/s, ten increments and as many fixes a second. Every step
/// moves, weighs and resamples.
inline constexpr double kDuration = 0.1;  ///< [s]
inline constexpr OdometryIncrement kIncrement{0.0, kDuration, 1.0, 0.1};
inline constexpr double kFixSigma = 0.3;  ///< [m]

inline OdometryIncrement increment(int step) {
  OdometryIncrement u = kIncrement;
  u.stamp = kDuration * (step + 1);
  return u;
}

inline GnssFix fix(int step) {
  const double turned = kIncrement.yaw_rate * kDuration * (step + 1);
  const double radius = kIncrement.speed / kIncrement.yaw_rate;
  GnssFix fix;
  fix.stamp = kDuration * (step + 1);
  fix.position = {radius * std::sin(turned) + kFixSigma * std::sin(37.0 * step),
                  radius * (1.0 - std::cos(turned)) + kFixSigma * std::cos(53.0 * step)};
  fix.covariance = kFixSigma * kFixSigma * Eigen::Matrix2d::Identity();
  return fix;
}

/// The method of [NIS] with all its terms, resampled at every fix.
inline NishidaParticleFilterParameters parameters(std::size_t size) {
  NishidaParticleFilterParameters parameters;
  parameters.sampling.min_particles = parameters.sampling.max_particles = static_cast<int>(size);
  parameters.ess_threshold = 2.0 * static_cast<double>(size);
  parameters.heading.fix_heading = FixHeadingSource::kPrinted;
  parameters.heading.fix_heading_distance = 0.0;
  return parameters;
}

}  // namespace multipath_localization::workload
