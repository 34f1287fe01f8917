#pragma once

#include <Eigen/Geometry>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// How the base leans against level, by the rule of REP-103: turned by yaw about the vertical first, by pitch
/// about its own y then, by roll about its own x at last. Nose down and right side down are positive [rad].
struct Tilt {
  double roll = 0.0;
  double pitch = 0.0;
};

/// Turns a vector from the base to the levelled base, which has the base's yaw and a vertical z axis.
Eigen::Matrix3d rotation(const Tilt& tilt);

/// The unit vector that points upwards, in the base.
Eigen::Vector3d up_in_base(const Tilt& tilt);

/// The tilt of a base in which `up` points upwards, of any length but zero.
Tilt tilt_of(const Eigen::Vector3d& up);

/// Where a point of the base lies in the plane, in the levelled base [m].
Eigen::Vector2d levelled(const Tilt& tilt, const Eigen::Vector3d& in_base);

/// What wheels measure along ground that leans so, as motion of the levelled base in the plane: the way is
/// shorter by the cosine, the turn is about the vertical.
OdometryIncrement over_map(const Tilt& tilt, OdometryIncrement along_ground);

/// The rate of the heading of a base that turns about the ground's normal, of its rate about the vertical:
/// that of a robot which turns on a slope is less, on average by the cosine.
YawRate over_map(const Tilt& tilt, YawRate about_vertical);

/// Motion in the plane as wheels measure it along ground that leans so: what `over_map` undoes.
OdometryIncrement along_ground(const Tilt& tilt, OdometryIncrement level);

}  // namespace multipath_localization
