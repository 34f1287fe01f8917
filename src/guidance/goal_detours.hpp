#pragma once

#include <Eigen/Core>
#include <vector>

#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/guidance/path.hpp"

namespace multipath_localization {

/// Ways to `goal` in map [m] that a base at `pose` can drive which turns by `radius` [m] at least: straight
/// on for some of the `run_ups` [m], round a circle to either side until the goal is ahead, and straight to
/// it. The shortest is the first. Any goal has some, as the base may go on until it lies outside the circle.
std::vector<Path> goal_detours(const Pose2& pose, const Eigen::Vector2d& goal, double radius,
                               const std::vector<double>& run_ups);

}  // namespace multipath_localization
