#pragma once

#include <rosbag/bag.h>

#include <string>
#include <vector>

namespace multipath_localization {

/// Where in a bag things are. An empty name stands for the default, below.
struct BagTopics {
  std::string fix;       ///< NavSatFix: `gps/fix`, or the only one of that type besides left and right
  std::string odometry;  ///< Odometry: `odom`, or the only one of that type besides truth
  std::string truth;     ///< PoseStamped or Odometry in an ENU frame: `truth`, or none
  std::string shadow;    ///< Vector3Stamped, z = 1 where fixes are biased: truth's name + `/bias`, or none
  std::string epoch;     ///< GnssEpoch: `gnss/epoch`, or the only one of that type, or none
  std::string left;      ///< NavSatFix of the left one of two antennas: `gps/left/fix`, or none
  std::string right;     ///< of the right one: `gps/right/fix`, or none
  std::string imu;       ///< Imu: `imu/data`, or the only one of that type, or none
  std::string velocity;  ///< TwistWithCovarianceStamped or TwistStamped: `gps/velocity`, or the only one that
                         ///< is named as drivers of receivers name it, or none
  std::string heading;   ///< Imu or PoseWithCovarianceStamped: `heading`, or none
  std::string level;     ///< GPSFix or NavPVT: `gps/level`, or the only one of such a type, or none
  std::vector<std::string> more_fixes;  ///< NavSatFix of further receivers: `gps_2/fix`, ..., or none
};

/// The names of a bag's topics as they stand in it, empty where there is none. Throws DriveError, naming
/// `file`, where a topic asked for is not there or of another type, where a default is not unique, and where
/// odometry or GNSS of any kind is missing.
BagTopics find_topics(const rosbag::Bag& bag, const std::string& file, const BagTopics& asked);

}  // namespace multipath_localization
