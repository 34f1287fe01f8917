#pragma once

#include <optional>

#include "estimators/multipath/heading_block.hpp"
#include "estimators/multipath/hypothesis_cloud.hpp"

namespace multipath_localization::multipath {

/// Finds how far headings that are disbelieved are off, if that is always the same: antennas that are mounted
/// across, or taken for each other, a compass that knows another north.
class HeadingOffset {
 public:
  /// Headings have been weighed, which led to that mixture. Their constant offset [rad], once it has been the
  /// same for long enough and whichever way the robot points: then it is to begin anew.
  std::optional<double> judge(const HeadingSighting& sighting, const Mixture& mixture);

 private:
  double mean_ = 0.0;      ///< [rad]
  int count_ = 0;          ///< of sightings that agree
  int misses_ = 0;         ///< of those since that do not
  double yaw_ = 0.0;       ///< of the robot at the last one [rad]
  double turned_ = 0.0;    ///< since the first of them, to the left [rad]
  double leftmost_ = 0.0;  ///< of that, when they agreed
  double rightmost_ = 0.0;
};

}  // namespace multipath_localization::multipath
