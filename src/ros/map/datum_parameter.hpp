#pragma once

#include <optional>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// The parameter `datum`: where a map has its origin, or empty. `[latitude, longitude, yaw]` as
/// robot_localization has it, where yaw is that of map's x axis against east; an altitude may follow. Map's
/// axes are east, north and up here, so that the yaw has to be 0.
struct DatumParameter {
  std::vector<double> numbers;

  /// Throws ParameterError on a datum that is no place, and on one that is turned.
  void fields(ParameterVisitor& field);

  [[nodiscard]] bool given() const { return !numbers.empty(); }
  /// The place, at that altitude [m] where none is given; nothing where there is no datum.
  [[nodiscard]] std::optional<Geodetic> place(double otherwise = 0.0) const;
};

}  // namespace multipath_localization
