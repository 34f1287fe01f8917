#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "evaluation/drive.hpp"
#include "simulation/random_robot.hpp"

namespace multipath_localization {

/// What a random robot is given beside odometry and fixes; what else it is does not change by it.
struct RandomExtras {
  bool gyro = false;
  bool velocity = false;
  bool receivers = false;  ///< a second one, of any kind, 0.8 m beside the first one
  bool heading = false;
  bool levels = false;  ///< RTK receivers tell theirs
};

/// An extra by the name that the command line has for it.
struct NamedExtra {
  const char* name;
  bool RandomExtras::*given;
};
constexpr std::array<NamedExtra, 5> kExtras = {{{"gyro", &RandomExtras::gyro},
                                                {"velocity", &RandomExtras::velocity},
                                                {"receivers", &RandomExtras::receivers},
                                                {"heading", &RandomExtras::heading},
                                                {"levels", &RandomExtras::levels}}};

/// A random robot's drive as a recording, and what only the oracle is told of it.
struct RandomDrive {
  RandomRobot robot;  ///< without its steps
  Drive drive;
  std::vector<FixTruth> fix_truths;               ///< of each of the first receiver's fixes
  std::vector<OdometryIncrement> without_faults;  ///< odometry, had the wheels had no faults
};

/// The drive of a seed, named random_SEED; the same bytes for the same seed. Truth ten times a second, twenty
/// times where fixes come as often.
RandomDrive random_drive(std::uint64_t seed, const RandomExtras& extras = {});

}  // namespace multipath_localization
