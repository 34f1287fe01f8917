#pragma once

#include <cmath>

#include "tools/benchmark/workload.hpp"

namespace multipath_localization {

/// The motion model for the peers' filters: Eqs. (3)-(8) of [NIS] for one pose, with the peer's own normals.
template <class Normal>
Pose2 peer_motion(const Pose2& pose, const OdometryIncrement& u, Normal&& normal) {
  const double steering = std::atan(u.yaw_rate / u.speed);
  const double sigma = std::sqrt(3e-3 * (3.0 * u.speed * u.speed + 0.3 * steering * steering));
  const double v = u.speed + sigma * normal();
  const double omega = v * std::tan(steering + sigma * normal());
  const double half = 0.5 * omega * u.duration;
  const double chord = v * u.duration * (std::abs(half) < 1e-6 ? 1.0 : std::sin(half) / half);
  return {pose.x + chord * std::cos(pose.yaw + half), pose.y + chord * std::sin(pose.yaw + half),
          wrap_angle(pose.yaw + (omega + sigma * normal()) * u.duration)};
}

/// Logarithm of a Gaussian position likelihood, up to a constant: cheaper than that of [NIS].
inline double peer_log_likelihood(double x, double y, const GnssFix& fix) {
  const double dx = x - fix.position.x();
  const double dy = y - fix.position.y();
  return -0.5 * (dx * dx + dy * dy) / (workload::kFixSigma * workload::kFixSigma);
}

}  // namespace multipath_localization
