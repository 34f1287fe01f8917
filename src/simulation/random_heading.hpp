#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/random_receiver.hpp"

namespace multipath_localization {

/// The headings that a random robot's second antenna or compass tells, as drawn.
struct RandomHeading {
  int period_ms = 200;
  double white_sigma = 0.0;    ///< [rad]
  double slow_sigma = 0.0;     ///< [rad]
  double slow_time = 1.0;      ///< correlation time of that [s]
  double offset = 0.0;         ///< constant [rad]
  double declared = 0.02;      ///< sigma [rad]
  double outlier_share = 0.0;  ///< of the time, in runs of a second or two in which it is any
};

/// The headings of the robot of a seed when it is to give any. What else the robot is does not change by it.
RandomHeading draw_heading(std::uint64_t seed);

/// What it says on a way. Deterministic by (heading, steps, seed).
std::vector<Heading> read_headings(const RandomHeading& heading, const std::vector<MotionStep>& steps,
                                   std::uint64_t seed);

}  // namespace multipath_localization
