#pragma once

#include <optional>
#include <string>

#include "multipath_localization/evaluation/drive.hpp"

namespace multipath_localization {

/// Where in a bag things are. An empty name stands for the default, below.
struct BagTopics {
  std::string fix;       ///< NavSatFix: `gps/fix`, or the only one of that type
  std::string odometry;  ///< Odometry: `odom`, or the only one of that type besides truth
  std::string truth;     ///< PoseStamped or Odometry in an ENU frame: `truth`, or none
  std::string shadow;    ///< Vector3Stamped, z = 1 where fixes are biased: truth's name + `/bias`, or none
};

/// Reads a bag as a drive. Names go with or without leading slash; stamps are those of the headers, the
/// arrival of a fix is the stamp of the last odometry recorded before it. Messages no node would use are left
/// out and counted in a notice. The antenna is taken to be at the base.
///
/// Truth is scored in its own frame, whose `datum` a bag does not say. Not given, it is taken from the bag:
/// the datum for which the median over the fixes in open sky of fix - truth is zero, or over all fixes where
/// nothing says which those are, which hides a constant error of the fixes; a notice tells. Without truth the
/// datum is the first fix. Throws DriveError.
Drive read_bag(const std::string& file, const BagTopics& topics, const std::optional<Geodetic>& datum);

}  // namespace multipath_localization
