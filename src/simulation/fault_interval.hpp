#pragma once

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// When a fault is there, in seconds after the start of the stream: all the time unless told otherwise.
struct FaultInterval {
  double start = 0.0;
  double duration = 1e9;

  [[nodiscard]] bool holds(double time) const { return time >= start && time < start + duration; }
  void fields(ParameterVisitor& field);
};

}  // namespace multipath_localization
