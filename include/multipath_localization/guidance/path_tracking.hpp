#pragma once

#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/guidance/path.hpp"

namespace multipath_localization {

/// The curvature [1/m] by which a base at `pose` in map comes onto a path and stays there, `foot` being the
/// place on it that is nearest:
///
///     kappa = curvature_ahead - 2 (sin(psi) + sat(e / 2 L)) / L
///
/// of the offset e to the left and the heading error psi. Near the path, and in the way along it, both then
/// decay by two equal real roots, 1 / L, so without overshoot; `settling_length` is L [m]. Far off the path,
/// sat holds the angle at which it is approached, and its bends do not count. A base that heads back turns as
/// tightly as `tightest_curvature` allows, whose limits the result keeps.
double tracking_curvature(const Pose2& pose, const PathPoint& foot, double curvature_ahead,
                          double settling_length, double tightest_curvature);

}  // namespace multipath_localization
