#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/random_way.hpp"

namespace multipath_localization {

/// A gyro beside the odometry of a random robot, as drawn.
struct RandomGyro {
  int period_ms = 10;
  double bias = 0.0;       ///< at the start [rad/s]
  double bias_walk = 0.0;  ///< [rad/s/sqrt(s)]
  double noise = 0.0;      ///< white [rad/sqrt(s)]
  double scale = 0.0;      ///< measured over true rate, minus 1
};

/// The gyro that the robot of a seed has when it is given one. What else the robot is does not change by it.
RandomGyro draw_gyro(std::uint64_t seed);

/// What the gyro reads on a way. Deterministic by (gyro, steps, seed).
std::vector<YawRate> read_gyro(const RandomGyro& gyro, const std::vector<MotionStep>& steps,
                               std::uint64_t seed);

}  // namespace multipath_localization
