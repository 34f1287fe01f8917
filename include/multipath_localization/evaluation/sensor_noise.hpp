#pragma once

#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/evaluation/drive.hpp"
#include "multipath_localization/evaluation/stretch_fit.hpp"

namespace multipath_localization {

/// White and wandering noise of one component of a fix.
struct FixNoise {
  double white_sigma = 0.0;             ///< [m]
  double coloured_sigma = 0.0;          ///< [m]; 0: no wander is seen
  std::optional<double> time_constant;  ///< of the wander [s]; nothing where it is longer than can be told
};

/// A figure, and how sure it is [1 sigma].
struct Measured {
  double value = 0.0;
  double sigma = 0.0;
};

/// What a drive tells of its sensors; nothing where it does not.
struct SensorNoise {
  double time = 0.0;          ///< of the drive that was looked at [s]
  double way = 0.0;           ///< [m]
  std::size_t stretches = 0;  ///< of it
  std::size_t quiet = 0;      ///< among them, from which all below is
  std::optional<FixNoise> fix;
  std::optional<Measured> scale;         ///< true speed over that of odometry
  std::optional<Measured> gyro_bias;     ///< of the yaw rate of odometry [rad/s]
  std::optional<Measured> delay;         ///< of the fixes' stamps [s]
  std::optional<double> distance_noise;  ///< [m/sqrt(m)]
  std::optional<double> yaw_noise;       ///< [rad/sqrt(s)]
  double latency = 0.0;                  ///< median from a fix's stamp to its arrival [s]
};

/// White and wandering noise by the structure function of the residuals of stretches: half the mean square of
/// differences `lag` apart is white^2 + coloured^2 (1 - exp(-lag / time constant)). Laying odometry on the
/// fixes takes out what is slower than a quarter of a stretch; such a wander is told as not to be told.
std::optional<FixNoise> fix_noise(const std::vector<StretchFit>& stretches);

/// Looks at a drive in stretches of `stretch` [s] while it moves; those with more than twice the residuals of
/// the best quarter are in the shadow of something and left out. Noise of odometry is what scale and gyro
/// bias vary by from stretch to stretch beyond what the fixes explain: over a stretch of T seconds a random
/// walk of the heading varies a fitted rate by 6/5 of its variance per second over T.
SensorNoise sensor_noise(const Drive& drive, double stretch);

}  // namespace multipath_localization
