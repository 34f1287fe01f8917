#pragma once

#include <optional>
#include <string>

#include "evaluation/drive.hpp"
#include "ros/bags/bag_topics.hpp"

namespace multipath_localization {

/// Reads a bag as a drive. Names go with or without leading slash; stamps are those of the headers, a
/// measurement arrives at the stamp of the last odometry recorded before it. Messages no node would use are
/// left out and counted in a notice. After a silence of odometry for which the node starts afresh the drive
/// has a restart and a notice says where. Antennas are where the transforms have them (AntennaFrames); a lone
/// one of an unknown frame is taken to be at the base.
///
/// Truth is scored in its own frame. Its datum, if not given, is told by a static transform earth -> that
/// frame. Without one it is the datum for which the median over the fixes in open sky of fix - truth is zero,
/// or over all fixes where nothing says which those are, which hides a constant error of the fixes; a notice
/// tells. Without truth it is the one the node would find (DatumSearch). Where there are no fixes their part
/// is taken by the pairs of two antennas, without those by the least-squares solutions of the epochs. Throws
/// DriveError.
Drive read_bag(const std::string& file, const BagTopics& topics, const std::optional<Geodetic>& datum);

}  // namespace multipath_localization
