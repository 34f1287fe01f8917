#include "multipath_localization/guidance/speed_profile.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

/// The speed from which braking over a distance leads to `end_speed`.
double braked_from(double end_speed, double deceleration, double distance) {
  return std::sqrt(end_speed * end_speed + 2.0 * deceleration * std::max(distance, 0.0));
}

double limit_in(double curvature, const SpeedLimits& limits) {
  const double driven = std::min(std::abs(curvature), limits.tightest_curvature);
  double speed = limits.cruise_speed;
  if (driven * speed * speed > limits.lateral_acceleration) {
    speed = std::sqrt(limits.lateral_acceleration / driven);
  }
  return driven * speed > limits.yaw_rate ? limits.yaw_rate / driven : speed;
}

}  // namespace

SpeedProfile::SpeedProfile(const Path& path, const SpeedLimits& limits, double end_speed)
    : deceleration_(limits.deceleration), stretches_(path.pieces().size()) {
  double exit_speed = end_speed;
  for (std::size_t i = stretches_.size(); i-- > 0;) {
    const PathPiece& piece = path.pieces()[i];
    const double limit = limit_in(piece.curvature, limits);
    stretches_[i] = {limit, std::min(exit_speed, limit)};
    exit_speed = std::min(limit, braked_from(stretches_[i].exit_speed, deceleration_, piece.length));
  }
}

double SpeedProfile::at(const Path& path, double s) const {
  const std::size_t i = path.piece_at(s);
  const Stretch& stretch = stretches_[i];
  return std::min(stretch.limit, braked_from(stretch.exit_speed, deceleration_, path.pieces()[i].end() - s));
}

}  // namespace multipath_localization
