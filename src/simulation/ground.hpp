#pragma once

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/tilt.hpp"

namespace multipath_localization {

/// Ground that rises to the east, evenly or in waves whose crests run north.
struct GroundParameters {
  double slope = 0.0;
  double wavelength = 0.0;

  void fields(ParameterVisitor& field);
  /// How a base at that place in map leans.
  [[nodiscard]] Tilt tilt(const Pose2& base_in_map) const;
};

}  // namespace multipath_localization
