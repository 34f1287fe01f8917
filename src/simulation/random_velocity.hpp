#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/random_receiver.hpp"

namespace multipath_localization {

/// The velocities by Doppler of a random robot's receiver, as drawn; standard deviations are of each
/// component.
struct RandomVelocity {
  int period_ms = 200;
  double white_sigma = 0.0;    ///< [m/s]
  double slow_sigma = 0.0;     ///< [m/s]
  double slow_time = 1.0;      ///< correlation time of that [s]
  int lag_ms = 0;              ///< it is the velocity of this long before its stamp
  double declared = 0.05;      ///< sigma [m/s]
  double outlier_share = 0.0;  ///< of the time, in runs of a second or two; twice as much in a shadow
  double outlier_sigma = 1.0;  ///< [m/s]
};

/// The velocities that the receiver of a seed gives when it is to give any. What else the robot is does not
/// change by it.
RandomVelocity draw_velocity(std::uint64_t seed);

/// What the receiver, of which outages and shadows count, says on a way. Deterministic by (velocity,
/// receiver, steps, seed).
std::vector<GnssVelocity> read_velocities(const RandomVelocity& velocity, const RandomReceiver& receiver,
                                          const std::vector<MotionStep>& steps, std::uint64_t seed);

}  // namespace multipath_localization
