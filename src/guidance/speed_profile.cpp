#include "multipath_localization/guidance/speed_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath_localization {

namespace {

constexpr double kSliver = 1e-6;         // of a piece, that counts to no zone [m]
constexpr double kTimeStep = 0.2;        // along the path, of a duration [m]
constexpr double kMostTimeSteps = 5000;  // longer ways have longer ones

/// The speed from which braking over a distance leads to `end_speed`.
double braked_from(double end_speed, double deceleration, double distance) {
  return std::sqrt(end_speed * end_speed + 2.0 * deceleration * std::max(distance, 0.0));
}

/// The speed v from which it does where `delay` [s] is driven at v before.
double braked_late_from(double end_speed, double deceleration, double distance, double delay) {
  const double late = deceleration * delay;
  const double from = braked_from(std::hypot(end_speed, late), deceleration, distance) - late;
  return std::max(end_speed, from);
}

double limit_in(double curvature, const SpeedLimits& limits) {
  const double driven = std::min(std::abs(curvature), limits.tightest_curvature);
  double speed = limits.cruise_speed;
  if (driven * speed * speed > limits.lateral_acceleration) {
    speed = std::sqrt(limits.lateral_acceleration / driven);
  }
  return driven * speed > limits.yaw_rate ? limits.yaw_rate / driven : speed;
}

/// Of a piece of a path, by the zones it lies in.
double limit_of(const std::vector<SpeedZone>& zones, const PathPiece& piece) {
  double limit = std::numeric_limits<double>::infinity();
  double begin = 0.0;
  for (const SpeedZone& zone : zones) {
    if (piece.end() > begin + kSliver && piece.begin < zone.end - kSliver)
      limit = std::min(limit, zone.speed);
    begin = zone.end;
  }
  return limit;
}

}  // namespace

SpeedProfile::SpeedProfile(const Path& path, const SpeedLimits& limits, double end_speed,
                           const std::vector<SpeedZone>& zones)
    : deceleration_(limits.deceleration),
      braking_delay_(limits.braking_delay),
      stretches_(path.pieces().size()) {
  double exit_speed = end_speed;
  for (std::size_t i = stretches_.size(); i-- > 0;) {
    const PathPiece& piece = path.pieces()[i];
    const double limit = std::min(limit_in(piece.curvature, limits), limit_of(zones, piece));
    stretches_[i] = {limit, std::min(exit_speed, limit)};
    exit_speed = std::min(limit, braked_from(stretches_[i].exit_speed, deceleration_, piece.length));
  }
}

double SpeedProfile::at(const Path& path, double s) const {
  const std::size_t i = path.piece_at(s);
  const Stretch& stretch = stretches_[i];
  const double left = path.pieces()[i].end() - s;
  return std::min(stretch.limit, braked_late_from(stretch.exit_speed, deceleration_, left, braking_delay_));
}

double SpeedProfile::duration(const Path& path, double from, double to) const {
  const double step = std::max(kTimeStep, (to - from) / kMostTimeSteps);
  double duration = 0.0;
  for (double s = from; s < to; s += step) {
    const double length = std::min(step, to - s);
    const double speed = at(path, s + 0.5 * length);
    if (speed <= 0.0) return std::numeric_limits<double>::infinity();
    duration += length / speed;
  }
  return duration;
}

}  // namespace multipath_localization
