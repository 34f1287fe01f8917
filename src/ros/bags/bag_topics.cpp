#include "ros/bags/bag_topics.hpp"

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/TwistWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/view.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>

#include <algorithm>
#include <map>
#include <vector>

#include "multipath_localization/GnssEpoch.h"
#include "ros/messages/conversions.hpp"
#include "ros/messages/gnss_message.hpp"
#include "support/csv.hpp"

namespace multipath_localization {

namespace {

const std::string kOdometry = ros::message_traits::datatype<nav_msgs::Odometry>();
const std::string kFix = ros::message_traits::datatype<sensor_msgs::NavSatFix>();
const std::string kEpoch = ros::message_traits::datatype<GnssEpoch>();
const std::string kImu = ros::message_traits::datatype<sensor_msgs::Imu>();
const std::string kPose = ros::message_traits::datatype<geometry_msgs::PoseWithCovarianceStamped>();
const std::string kVelocity = ros::message_traits::datatype<geometry_msgs::TwistWithCovarianceStamped>();
const std::vector<std::string> kLevels = {"gps_common/GPSFix", "ublox_msgs/NavPVT", "ublox_msgs/NavPVT7"};
const std::string kBareVelocity = ros::message_traits::datatype<geometry_msgs::TwistStamped>();

/// Whether the last part of a topic's name is what drivers of ublox and NMEA receivers call the velocity.
bool named_by_receiver(const std::string& topic) {
  const std::string last = topic.substr(topic.rfind('/') + 1);
  return last == "fix_velocity" || last == "vel";
}

/// The topics of a bag by type, and how the wanted ones are found among them.
class TopicList {
 public:
  TopicList(const rosbag::Bag& bag, std::string file) : file_(std::move(file)) {
    rosbag::View view(bag);
    for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
      types_.emplace(connection->topic, connection->datatype);
    }
  }

  /// The topic asked for, or else the one of that default name, or else none.
  [[nodiscard]] std::string named(const std::string& asked, const std::string& otherwise,
                                  const std::vector<std::string>& types) const {
    for (const auto& [topic, type] : types_) {
      if (without_slash(topic) != without_slash(asked.empty() ? otherwise : asked)) continue;
      if (std::find(types.begin(), types.end(), type) != types.end()) return topic;
      if (!asked.empty()) {
        throw DriveError(file_ + ": " + topic + " is a " + type + ", not a " + types.front());
      }
    }
    if (!asked.empty()) throw missing("topic " + asked);
    return "";
  }

  /// The same, or else the only topic of that type besides those `taken`, or else none.
  [[nodiscard]] std::string named_or_only(const std::string& asked, const std::string& otherwise,
                                          const std::string& type,
                                          const std::vector<std::string>& taken = {}) const {
    std::string found = named(asked, otherwise, {type});
    if (!found.empty()) return found;
    for (const auto& [topic, its_type] : types_) {
      if (its_type != type || std::find(taken.begin(), taken.end(), topic) != taken.end()) continue;
      if (!found.empty()) throw DriveError(file_ + ": several " + type + ", name one of" + all());
      found = topic;
    }
    return found;
  }

  /// The same, or else the only topic of one of the types that passes, or else none.
  template <class Passes>
  [[nodiscard]] std::string named_or_single(const std::string& asked, const std::string& otherwise,
                                            const std::vector<std::string>& types,
                                            const Passes& passes) const {
    std::string found = named(asked, otherwise, types);
    if (!found.empty()) return found;
    std::vector<std::string> all;
    for (const auto& [topic, type] : types_) {
      if (std::find(types.begin(), types.end(), type) != types.end() && passes(topic)) all.push_back(topic);
    }
    return all.size() == 1 ? all.front() : "";
  }

  [[nodiscard]] DriveError missing(const std::string& what) const {
    return DriveError(file_ + ": no " + what + "; there are" + all());
  }

 private:
  [[nodiscard]] std::string all() const {
    std::string text;
    for (const auto& [topic, type] : types_) text += " " + topic + " (" + type + ")";
    return text;
  }

  std::string file_;
  std::map<std::string, std::string> types_;
};

/// Those asked for or, where none are, those of the default names as far as they go on.
std::vector<std::string> more_fixes(const TopicList& list, const std::vector<std::string>& asked) {
  std::vector<std::string> found;
  for (const std::string& topic : asked) found.push_back(list.named(topic, "", {kFix}));
  for (std::size_t k = 1; asked.empty() && k < kMostReceivers; ++k) {
    const std::string topic = list.named("", fix_topic(k), {kFix});
    if (topic.empty()) break;
    found.push_back(topic);
  }
  return found;
}

}  // namespace

BagTopics find_topics(const rosbag::Bag& bag, const std::string& file, const BagTopics& asked) {
  const TopicList list(bag, file);
  BagTopics found;
  found.truth = list.named(asked.truth, "truth", {"geometry_msgs/PoseStamped", kOdometry});
  found.shadow = list.named(asked.shadow, found.truth + "/bias", {"geometry_msgs/Vector3Stamped"});
  found.left = list.named(asked.left, "gps/left/fix", {kFix});
  found.right = list.named(asked.right, "gps/right/fix", {kFix});
  found.more_fixes = more_fixes(list, asked.more_fixes);
  std::vector<std::string> taken = found.more_fixes;
  taken.insert(taken.end(), {found.left, found.right});
  found.fix = list.named_or_only(asked.fix, "gps/fix", kFix, taken);
  found.epoch = list.named_or_only(asked.epoch, "gnss/epoch", kEpoch);
  found.heading = list.named(asked.heading, "heading", {kImu, kPose});
  found.imu = list.named_or_single(asked.imu, "imu/data", {kImu},
                                   [&](const std::string& topic) { return topic != found.heading; });
  found.velocity =
      list.named_or_single(asked.velocity, "gps/velocity", {kVelocity, kBareVelocity}, &named_by_receiver);
  found.level =
      list.named_or_single(asked.level, level_topic(0), kLevels, [](const std::string&) { return true; });
  found.odometry = list.named_or_only(asked.odometry, "odom", kOdometry, {found.truth});
  if (found.odometry.empty()) throw list.missing(kOdometry);
  const bool pair = !found.left.empty() && !found.right.empty();
  if (found.fix.empty() && found.epoch.empty() && !pair) throw list.missing(kFix + " and no " + kEpoch);
  return found;
}

}  // namespace multipath_localization
