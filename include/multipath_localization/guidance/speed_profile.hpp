#pragma once

#include <vector>

#include "multipath_localization/guidance/path.hpp"

namespace multipath_localization {

/// What a base may do along a path.
struct SpeedLimits {
  double cruise_speed;          ///< [m/s]
  double lateral_acceleration;  ///< [m/s^2]
  double deceleration;          ///< [m/s^2]
  double yaw_rate;              ///< [rad/s]
  double tightest_curvature;    ///< it can drive; tighter bends of the path are driven as this one [1/m]
  double braking_delay = 0.0;   ///< from the order to brake until it tells, in the mean [s]
};

/// A part of a path, from the end of the one before on, that is driven no faster than told.
struct SpeedZone {
  double end;    ///< along the path [m]
  double speed;  ///< at most [m/s]
};

/// The speed along a path: the cruise speed, less in its bends by their lateral acceleration, and before
/// slower stretches and the end by what braking, begun earlier by its delay, allows.
class SpeedProfile {
 public:
  /// `end_speed` is that at the end of the path [m/s]. A piece of the path in several zones counts to the
  /// slowest; beyond the last one the cruise speed holds.
  SpeedProfile(const Path& path, const SpeedLimits& limits, double end_speed,
               const std::vector<SpeedZone>& zones = {});

  /// `s` [m] along the path it was made for; before its beginning, that there [m/s].
  [[nodiscard]] double at(const Path& path, double s) const;
  /// From one place on the path to another [s], as if it sped up at once; infinity where it may not drive.
  [[nodiscard]] double duration(const Path& path, double from, double to) const;

 private:
  /// Of one piece of the path.
  struct Stretch {
    double limit;       ///< [m/s]
    double exit_speed;  ///< at its end [m/s]
  };

  double deceleration_;
  double braking_delay_;
  std::vector<Stretch> stretches_;
};

}  // namespace multipath_localization
