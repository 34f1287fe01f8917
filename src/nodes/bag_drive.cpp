#include "nodes/bag_drive.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/NavSatFix.h>
#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "multipath_localization/evaluation/metrics.hpp"
#include "nodes/conversions.hpp"
#include "nodes/odometry_reader.hpp"

namespace multipath_localization {

namespace {

/// The topics of a bag by type, and how the wanted ones are found among them.
class TopicList {
 public:
  TopicList(const rosbag::Bag& bag, std::string file) : file_(std::move(file)) {
    rosbag::View view(bag);
    for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
      types_[connection->topic] = connection->datatype;
    }
  }

  /// The topic asked for, or else the one of that default name, or else none.
  [[nodiscard]] std::string named(const std::string& asked, const std::string& otherwise,
                                  const std::vector<std::string>& types) const {
    for (const auto& [topic, type] : types_) {
      if (without_slash(topic) != without_slash(asked.empty() ? otherwise : asked)) continue;
      if (std::find(types.begin(), types.end(), type) != types.end()) return topic;
      if (!asked.empty())
        throw DriveError(file_ + ": " + topic + " is a " + type + ", not a " + types.front());
    }
    if (!asked.empty()) throw DriveError(file_ + ": no topic " + asked + "; there are" + all());
    return "";
  }

  /// The same, or else the only topic of that type besides `taken`.
  [[nodiscard]] std::string required(const std::string& asked, const std::string& otherwise,
                                     const std::string& type, const std::string& taken = "") const {
    std::string found = named(asked, otherwise, {type});
    if (!found.empty()) return found;
    for (const auto& [topic, its_type] : types_) {
      if (its_type != type || topic == taken) continue;
      if (!found.empty()) throw DriveError(file_ + ": several " + type + ", name one of" + all());
      found = topic;
    }
    if (found.empty()) throw DriveError(file_ + ": no " + type + "; there are" + all());
    return found;
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

struct ReceivedFix {
  sensor_msgs::NavSatFix message;
  double arrival;
  Eigen::Vector2d antenna_in_base = Eigen::Vector2d::Zero();
};

/// Collects a bag's messages in the order they were recorded, as the localization node would take them.
class Collector {
 public:
  Collector(std::string file, const BagTopics& topics) : file_(std::move(file)), topics_(topics) {}

  void take(const rosbag::MessageInstance& message) {
    const std::string& topic = message.getTopic();
    if (without_slash(topic) == "tf_static") add(*message.instantiate<tf2_msgs::TFMessage>());
    if (topic == topics_.odometry) add(*message.instantiate<nav_msgs::Odometry>());
    if (topic == topics_.fix) add(*message.instantiate<sensor_msgs::NavSatFix>());
    if (topic == topics_.truth) {
      const auto pose = message.instantiate<geometry_msgs::PoseStamped>();
      const auto odometry = message.instantiate<nav_msgs::Odometry>();
      if (pose) add_truth(pose->header.stamp.toSec(), pose->pose);
      if (odometry) add_truth(odometry->header.stamp.toSec(), odometry->pose.pose);
    }
    if (topic == topics_.shadow) {
      const auto bias = message.instantiate<geometry_msgs::Vector3Stamped>();
      shadows_[bias->header.stamp.toSec()] = bias->vector.z > 0.5;
    }
  }

  /// Truth by stamp, with the shadow flag last said at each.
  [[nodiscard]] std::vector<TruthSample> truth() const {
    std::vector<TruthSample> samples;
    for (const auto& [stamp, base_in_map] : truth_) {
      samples.push_back({stamp, base_in_map, turns_, std::nullopt});
      const auto later = shadows_.upper_bound(stamp);
      if (shadows_.empty()) continue;
      samples.back().shadow = later == shadows_.begin() ? later->second : std::prev(later)->second;
    }
    return samples;
  }

  /// Where in the base the antenna of that frame is, nothing when the bag's static transforms do not tell.
  [[nodiscard]] std::optional<Eigen::Vector2d> antenna_in_base(const std::string& frame) const {
    if (frame == base_frame_) return Eigen::Vector2d::Zero();
    try {
      const auto antenna = tf_.lookupTransform(base_frame_, frame, ros::Time(0)).transform.translation;
      return Eigen::Vector2d(antenna.x, antenna.y);
    } catch (const tf2::TransformException&) {
      return std::nullopt;
    }
  }

  [[nodiscard]] const std::vector<OdometryIncrement>& odometry() const { return odometry_; }
  [[nodiscard]] const std::vector<ReceivedFix>& fixes() const { return fixes_; }
  [[nodiscard]] const std::map<std::string, int>& refusals() const { return refusals_; }

 private:
  bool accepted(const std::string& topic, Reason reason) {
    if (reason == Reason::kAccepted) return true;
    ++refusals_[topic + ": " + std::string(to_string(reason))];
    return false;
  }

  void add(const nav_msgs::Odometry& message) {
    const CheckedOdometry checked = reader_.read(message);
    if (!accepted(topics_.odometry, checked.reason)) return;
    if (checked.restarted) throw DriveError(file_ + ": " + topics_.odometry + " jumps in time");
    odometry_.push_back(checked.increment);
    base_frame_ = without_slash(message.child_frame_id);
  }

  void add(const sensor_msgs::NavSatFix& message) {
    if (!accepted(topics_.fix, check(message, {}))) return;
    fixes_.push_back({message, odometry_.empty() ? message.header.stamp.toSec() : odometry_.back().stamp});
  }

  void add(const tf2_msgs::TFMessage& message) {
    for (const geometry_msgs::TransformStamped& transform : message.transforms) {
      tf_.setTransform(transform, "bag", true);
    }
  }

  void add_truth(double stamp, const geometry_msgs::Pose& message) {
    const std::optional<Pose2> pose = to_pose2(message);
    if (!accepted(topics_.truth, pose ? Reason::kAccepted : Reason::kInvalidPosition)) return;
    turns_ = turns_ || pose->yaw != 0.0;
    truth_[stamp] = *pose;
  }

  std::string file_;
  BagTopics topics_;
  OdometryReader reader_{{}, ""};
  tf2::BufferCore tf_;
  std::string base_frame_;
  std::vector<OdometryIncrement> odometry_;
  std::vector<ReceivedFix> fixes_;
  std::map<double, Pose2> truth_;
  std::map<double, bool> shadows_;
  bool turns_ = false;  ///< truth has a heading: one that is always zero was never filled in
  std::map<std::string, int> refusals_;
};

/// Finds the antenna of each fix; where it is unknown it is taken to be at the base, as by the node.
void place_antennas(const Collector& bag, std::vector<ReceivedFix>& fixes,
                    std::vector<std::string>& notices) {
  std::set<std::string> unknown;
  for (ReceivedFix& fix : fixes) {
    const std::string frame = without_slash(fix.message.header.frame_id);
    const std::optional<Eigen::Vector2d> antenna = bag.antenna_in_base(frame);
    if (antenna) {
      fix.antenna_in_base = *antenna;
    } else if (unknown.insert(frame).second) {
      notices.push_back("no static transform to '" + frame + "': the antenna is taken to be at the base");
    }
  }
}

/// The datum on which the fixes lie on truth, see `read_bag`.
Geodetic fitted_datum(const std::vector<ReceivedFix>& fixes, const std::vector<TruthSample>& truth,
                      std::vector<std::string>& notices) {
  const LocalFrame frame(to_geodetic(fixes.front().message));
  std::map<bool, std::array<std::vector<double>, 2>> offsets;  // east and north, by whether the sky is open
  for (const ReceivedFix& fix : fixes) {
    const std::optional<TruthSample> sample = truth_at(truth, fix.message.header.stamp.toSec());
    if (!sample) continue;
    const Eigen::Vector2d offset =
        frame.to_map(to_geodetic(fix.message)) - antenna_in_map(*sample, fix.antenna_in_base);
    const bool open = sample->shadow.has_value() && !*sample->shadow;
    offsets[open][0].push_back(offset.x());
    offsets[open][1].push_back(offset.y());
  }
  if (offsets.empty()) throw DriveError("no fix while there is truth: say the datum of its frame");
  const auto& [open, best] = *offsets.rbegin();
  const Geodetic datum = frame.to_geodetic({quantile(best[0], 0.5), quantile(best[1], 0.5)});
  char text[300];
  std::snprintf(
      text, sizeof(text), "truth's datum is not in the bag: %.7f, %.7f by the median of %zu %s",
      datum.latitude_deg, datum.longitude_deg, best[0].size(),
      open ? "fixes in open sky"
           : "fixes, in open sky or not, which hides what is constant in their error; --datum tells it");
  notices.emplace_back(text);
  return datum;
}

Geodetic choose_datum(const std::vector<ReceivedFix>& fixes, const std::optional<Geodetic>& datum,
                      Drive& drive) {
  if (datum) return *datum;
  if (drive.truth.empty()) return to_geodetic(fixes.front().message);
  return fitted_datum(fixes, drive.truth, drive.notices);
}

BagTopics find_topics(const rosbag::Bag& bag, const std::string& file, const BagTopics& asked) {
  const std::string odometry_type = "nav_msgs/Odometry";
  const TopicList list(bag, file);
  BagTopics found;
  found.truth = list.named(asked.truth, "truth", {"geometry_msgs/PoseStamped", odometry_type});
  found.fix = list.required(asked.fix, "gps/fix", "sensor_msgs/NavSatFix");
  found.odometry = list.required(asked.odometry, "odom", odometry_type, found.truth);
  found.shadow = list.named(asked.shadow, found.truth + "/bias", {"geometry_msgs/Vector3Stamped"});
  return found;
}

}  // namespace

Drive read_bag(const std::string& file, const BagTopics& topics, const std::optional<Geodetic>& datum) {
  try {
    const rosbag::Bag bag(file);
    const BagTopics found = find_topics(bag, file, topics);
    Collector collector(file, found);
    for (const rosbag::MessageInstance& message : rosbag::View(bag)) collector.take(message);
    if (collector.odometry().empty()) throw DriveError(file + ": no usable odometry");
    std::vector<ReceivedFix> fixes = collector.fixes();
    if (fixes.empty()) throw DriveError(file + ": no usable fix");

    Drive drive;
    drive.name = std::filesystem::path(file).stem().string();
    drive.odometry = collector.odometry();
    drive.truth = collector.truth();
    if (drive.truth.empty()) drive.notices.emplace_back("no truth: nothing is scored");
    for (const auto& [refusal, times] : collector.refusals()) {
      drive.notices.push_back(refusal + ", " + std::to_string(times) + " times");
    }
    place_antennas(collector, fixes, drive.notices);
    drive.datum = choose_datum(fixes, datum, drive);
    const LocalFrame map(drive.datum);
    for (const ReceivedFix& received : fixes) {
      const CheckedFix checked = to_fix(received.message, map, {}, received.antenna_in_base);
      if (checked.reason == Reason::kAccepted) drive.fixes.push_back({checked.fix, received.arrival});
    }
    return drive;
  } catch (const rosbag::BagException& error) {
    throw DriveError(file + ": " + error.what());
  }
}

}  // namespace multipath_localization
