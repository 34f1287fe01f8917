#include "simulation/fault_interval.hpp"

namespace multipath_localization {

void FaultInterval::fields(ParameterVisitor& field) {
  field("start", start, {0.0, 1e9}, "s", "after the start of the stream");
  field("duration", duration, {0.0, 1e9}, "s", "for this long");
}

}  // namespace multipath_localization
