#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What the markers show, all of one moment.
struct LocalizationPicture {
  std_msgs::Header header;  ///< frame: map
  PoseEstimate estimate;
  std::vector<Hypothesis> hypotheses;
  std::optional<GnssFix> fix;  ///< the last one
  std::string state;           ///< text over the robot
};

/// Markers for rviz, one namespace each: `particles` coloured by mode (open sky green, shadow orange, canyon
/// violet), `covariance` the ellipse of 2 sigma over all hypotheses, `bias` an arrow from where the last fix
/// should lie to where it lies, `ring` the circle round the fix on which the antenna is by the length of the
/// bias, `state` text. At most `max_particles` points.
visualization_msgs::MarkerArray to_markers(const LocalizationPicture& picture, std::size_t max_particles);

}  // namespace multipath_localization
