#include "ros/bags/bag_file.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/NavSatFix.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "multipath_localization/GnssEpoch.h"
#include "support/csv.hpp"

namespace multipath_localization {

namespace {

namespace traits = ros::message_traits;

template <class... Messages>
std::map<std::string, std::string> md5sums() {
  return {{traits::datatype<Messages>(), traits::md5sum<Messages>()}...};
}

/// What does not depend on the bag's content; empty where it may be one.
std::string defect_of_file(const std::string& file) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(file, failure);
  if (!std::filesystem::exists(status)) return "there is no such file";
  if (std::filesystem::is_directory(status)) return "a folder, not a bag";
  if (std::filesystem::file_size(file, failure) == 0) return "an empty file, not a bag";
  const std::string magic = "#ROSBAG V";
  std::string begin(magic.size(), ' ');
  std::ifstream(file, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == magic ? "" : "not a bag";
}

}  // namespace

void with_bag(const std::string& file, const std::function<void(const rosbag::Bag&)>& use) {
  const std::string defect = defect_of_file(file);
  if (!defect.empty()) throw DriveError(file + ": " + defect);
  const std::string mend = "; run rosbag reindex " + file;
  try {
    use(rosbag::Bag(file));
  } catch (const rosbag::BagUnindexedException&) {
    throw DriveError(file + ": no index, as of a recording that was cut off" + mend);
  } catch (const rosbag::BagIOException& error) {
    throw DriveError(file + ": " + error.what() + ", as of a file that is cut off" + mend);
  } catch (const rosbag::BagException& error) {
    throw DriveError(file + ": " + error.what());
  } catch (const ros::serialization::StreamOverrunException&) {
    throw DriveError(file + ": a message that is shorter than its type");
  }
}

bool of_another_version(const rosbag::ConnectionInfo& connection) {
  static const auto kRead = md5sums<nav_msgs::Odometry, sensor_msgs::NavSatFix, geometry_msgs::PoseStamped,
                                    geometry_msgs::Vector3Stamped, tf2_msgs::TFMessage, GnssEpoch>();
  const auto known = kRead.find(connection.datatype);
  return known != kRead.end() && known->second != connection.md5sum;
}

}  // namespace multipath_localization
