#pragma once

#include <geometry_msgs/Transform.h>

#include <Eigen/Geometry>
#include <optional>

#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

/// Name of the Earth-centred, Earth-fixed frame in REP-105.
constexpr char kEarthFrame[] = "earth";

/// Where map lies on the Earth, as the transform earth -> map tells it.
geometry_msgs::Transform map_in_earth(const LocalFrame& map);

/// The way back: the datum of the map that lies there. Nothing where the frame's axes are not east, north and
/// up at its origin.
std::optional<Geodetic> datum_of(const Eigen::Isometry3d& map_in_earth);

}  // namespace multipath_localization
