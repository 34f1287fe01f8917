#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"

namespace multipath_localization {

/// A place to come to rest at.
struct Goal {
  Eigen::Vector2d position;       ///< in map [m]
  std::optional<double> heading;  ///< there, counter-clockwise from east [rad]
};

/// The waypoints to a goal, for a base at `pose` in map where that is known. One that turns on the spot, or
/// may have any heading there, goes straight. Another gets a waypoint so far before the goal, on the line
/// through it along the heading, that it is on that line when it comes to the goal; none where it is on that
/// line already.
std::vector<Eigen::Vector2d> approach(const Goal& goal, const std::optional<Pose2>& pose,
                                      const WaypointFollowerParameters& parameters);

}  // namespace multipath_localization
