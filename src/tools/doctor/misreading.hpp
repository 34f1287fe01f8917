#pragma once

#include <optional>
#include <string>

#include "tools/doctor/observations.hpp"

namespace multipath_localization {

/// A way to read latitude and longitude by which the fixes go the way of odometry, which they do not as they
/// are.
struct Misreading {
  std::string as;        ///< "in radians", "swapped", ...
  std::string remedy;    ///< in the receiver's driver
  Geodetic place;        ///< where the robot is by the fixes as they are
  Geodetic other_place;  ///< and read that way
};

/// Nothing where the fixes go the way of odometry as they are, or by no reading that a driver is known for.
std::optional<Misreading> misreading(const Observations& seen);

}  // namespace multipath_localization
