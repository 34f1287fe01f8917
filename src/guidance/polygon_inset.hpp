#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "guidance/ring.hpp"

namespace multipath_localization {

/// Why corners [m] are no simple polygon with an area: fewer than three, edges that cross, ... Empty where
/// they are one.
std::string fault_of_polygon(const std::vector<Eigen::Vector2d>& corners);

/// What lies `distance` [m] or more within a ring: none, one or several parts. Corners that point inwards
/// stay corners.
std::vector<Ring> inset(const Ring& ring, double distance);

}  // namespace multipath_localization
