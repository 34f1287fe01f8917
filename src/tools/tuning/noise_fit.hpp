#pragma once

#include <cstddef>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "tools/tuning/fix_sequence.hpp"

namespace multipath_localization {

/// What a drive says of one number: the likeliest value and the range beyond which it explains the drive
/// clearly worse (by 2 of log likelihood, 95 %), the other numbers being as suits it best.
struct Told {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  bool low_told = false;   ///< smaller values are ruled out
  bool high_told = false;  ///< larger values are ruled out

  /// Whether this drive tells the number itself, not only a bound: to within a factor of two either way.
  [[nodiscard]] bool told() const;
};

/// What a drive says of its sensors.
struct NoiseFit {
  Told distance;     ///< [m/sqrt(m)], as in SensorNoise
  Told yaw;          ///< [rad/sqrt(s)]
  Told white;        ///< [m]
  Told wander;       ///< [m]
  Told wander_time;  ///< [s]
  /// Of the fixes' stamps behind the odometry's [s]; told where speeds differ enough to part it from
  /// `antenna_ahead`, of which one second is worth a second's way.
  Told delay;
  Told antenna_ahead;           ///< how much further ahead the antenna is than told [m]; told likewise
  Told behind;                  ///< how far fixes are behind, by whichever of the two, at the mean speed [m]
  bool odometry_leaps = false;  ///< by what no robot drives, so that it tells neither
  FittedConstant scale;
  FittedConstant gyro_bias;
  std::size_t fixes = 0;
  double way = 0.0;          ///< driven between the first and the last fix [m]
  double moving_time = 0.0;  ///< [s]
};

/// Fits the noise by maximum likelihood. Fixes by stamp, in open sky; too few give a fit that tells nothing.
NoiseFit fit_noise(const std::vector<OdometryIncrement>& reported, const std::vector<GnssFix>& fixes);

}  // namespace multipath_localization
