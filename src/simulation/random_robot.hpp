#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/random_odometry.hpp"
#include "simulation/random_receiver.hpp"
#include "simulation/random_way.hpp"

namespace multipath_localization {

/// A robot of which nothing is known beforehand, drawn from random_ranges.hpp, and the way it drives.
struct RandomRobot {
  RandomWay way;
  RandomOdometry odometry;
  RandomReceiver receiver;
  std::vector<MotionStep> steps;  ///< the drive
};

/// The robot of a seed; deterministic.
RandomRobot draw_robot(std::uint64_t seed);

/// What was drawn, in one line.
std::string describe(const RandomRobot& robot);

}  // namespace multipath_localization
