#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evaluation/runner.hpp"
#include "evaluation/scenario.hpp"

namespace multipath_localization {

/// How a robot got round its waypoints when it was steered.
struct Course {
  std::size_t waypoints_passed = 0;  ///< as the follower saw it, in order, over all laps
  int laps = 0;
  std::optional<double> worst_miss;  ///< largest of the true distances at which waypoints were passed [m]
  double standing = 0.0;             ///< time the follower had the robot stopped [s]
};

/// A simulated run: what was recorded, how the estimator did, and where the robot got to.
struct ClosedLoopRun {
  Drive drive;                ///< replaying it by `run_drive` gives the same epochs
  std::vector<Epoch> epochs;  ///< one per step of the simulator
  Course course;
};

/// Simulates a scenario in which the waypoint follower steers on the estimate, or on the truth where the
/// scenario says so, or a sequence of commands is driven whatever the estimate. At every step: the command
/// for the estimate after the last odometry, one step of robot and receiver, then odometry and fixes as they
/// come in. The distance at which a waypoint was passed is that of the closest approach from when it was
/// steered for until the next one was passed. Throws RunError.
ClosedLoopRun run_scenario(const Scenario& scenario, std::uint64_t seed, const EstimatorFactory& make,
                           const RunSettings& settings, const ProgressReport& progress = nullptr,
                           const FateReport& fate = nullptr);

}  // namespace multipath_localization
