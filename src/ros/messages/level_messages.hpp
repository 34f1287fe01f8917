#pragma once

#include <topic_tools/shape_shifter.h>

#include <optional>

#include "multipath_localization/core/measurements.hpp"

/// The levels of fixes in messages of receivers' drivers, read without their packages.
namespace multipath_localization {

/// The level of the fix of that stamp.
struct ToldLevel {
  double stamp = 0.0;  ///< [s]
  FixLevel level = FixLevel::kUntold;
};

/// What a gps_common/GPSFix or a ublox_msgs/NavPVT or NavPVT7 tells; nothing of any other message, and of one
/// that is no fix, has no stamp or ends early. A GPSFix of before gps_common 0.3 knows no carrier phase: what
/// is corrected from the ground is untold then, as it may be that.
std::optional<ToldLevel> level_of(const topic_tools::ShapeShifter& message);

}  // namespace multipath_localization
