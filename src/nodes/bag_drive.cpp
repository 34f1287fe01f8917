#include "nodes/bag_drive.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/NavSatFix.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "multipath_localization/evaluation/metrics.hpp"

namespace multipath_localization {

namespace {

struct GeodeticFix {
  double stamp;
  Geodetic point;
  Eigen::Matrix2d covariance;
  double arrival;
};

std::string without_slash(const std::string& topic) {
  return !topic.empty() && topic.front() == '/' ? topic.substr(1) : topic;
}

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

/// Collects a bag's messages in the order they were recorded.
class Collector {
 public:
  explicit Collector(const BagTopics& topics) : topics_(topics) {}

  void take(const rosbag::MessageInstance& message) {
    if (message.getTopic() == topics_.odometry) add(*message.instantiate<nav_msgs::Odometry>());
    if (message.getTopic() == topics_.fix) add(*message.instantiate<sensor_msgs::NavSatFix>());
    if (message.getTopic() == topics_.truth) {
      const auto pose = message.instantiate<geometry_msgs::PoseStamped>();
      const auto odometry = message.instantiate<nav_msgs::Odometry>();
      if (pose) add_truth(pose->header.stamp.toSec(), pose->pose);
      if (odometry) add_truth(odometry->header.stamp.toSec(), odometry->pose.pose);
    }
    if (message.getTopic() == topics_.shadow) {
      const auto bias = message.instantiate<geometry_msgs::Vector3Stamped>();
      shadows_[bias->header.stamp.toSec()] = bias->vector.z > 0.5;
    }
  }

  /// Truth by stamp, with the shadow flag last said at each.
  [[nodiscard]] std::vector<TruthSample> truth() const {
    std::vector<TruthSample> samples;
    for (const auto& [stamp, sample] : truth_) {
      samples.push_back(sample);
      samples.back().has_yaw = turns_;
      const auto later = shadows_.upper_bound(stamp);
      if (!shadows_.empty())
        samples.back().shadow = later == shadows_.begin() ? later->second : std::prev(later)->second;
    }
    return samples;
  }

  [[nodiscard]] const std::vector<TwistSample>& twists() const { return twists_; }
  [[nodiscard]] const std::vector<GeodeticFix>& fixes() const { return fixes_; }
  [[nodiscard]] std::size_t left_out() const { return left_out_; }

 private:
  void add(const nav_msgs::Odometry& message) {
    const TwistSample twist{message.header.stamp.toSec(), message.twist.twist.linear.x,
                            message.twist.twist.angular.z};
    const bool in_order = twists_.empty() || twist.stamp > twists_.back().stamp;
    if (in_order && std::isfinite(twist.speed) && std::isfinite(twist.yaw_rate)) {
      twists_.push_back(twist);
    } else {
      ++left_out_;
    }
  }

  void add(const sensor_msgs::NavSatFix& message) {
    const Geodetic point{message.latitude, message.longitude, message.altitude};
    const auto& c = message.position_covariance;
    const double stamp = message.header.stamp.toSec();
    if (message.status.status < 0 || !valid(point)) {
      ++left_out_;
      return;
    }
    const Eigen::Matrix2d covariance = (Eigen::Matrix2d() << c[0], c[1], c[3], c[4]).finished();
    fixes_.push_back({stamp, point, covariance, twists_.empty() ? stamp : twists_.back().stamp});
  }

  void add_truth(double stamp, const geometry_msgs::Pose& pose) {
    const auto& q = pose.orientation;
    TruthSample sample;
    sample.stamp = stamp;
    sample.base_in_map = {pose.position.x, pose.position.y,
                          std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))};
    if (!sample.base_in_map.finite()) {
      ++left_out_;
      return;
    }
    turns_ = turns_ || q.z != 0.0;
    truth_[stamp] = sample;
  }

  BagTopics topics_;
  std::vector<TwistSample> twists_;
  std::vector<GeodeticFix> fixes_;
  std::map<double, TruthSample> truth_;
  std::map<double, bool> shadows_;
  bool turns_ = false;  ///< truth has a heading: one that is always zero was never filled in
  std::size_t left_out_ = 0;
};

/// The datum on which the fixes lie on truth, see `read_bag`.
Geodetic fitted_datum(const std::vector<GeodeticFix>& fixes, const std::vector<TruthSample>& truth,
                      std::vector<std::string>& notices) {
  const LocalFrame frame(fixes.front().point);
  std::vector<double> east[2];
  std::vector<double> north[2];
  for (const GeodeticFix& fix : fixes) {
    const std::optional<TruthSample> sample = truth_at(truth, fix.stamp);
    if (!sample) continue;
    const Eigen::Vector2d offset = frame.to_map(fix.point) - sample->base_in_map.position();
    const int open = sample->shadow == false ? 1 : 0;
    east[open].push_back(offset.x());
    north[open].push_back(offset.y());
  }
  const int open = east[1].empty() ? 0 : 1;
  if (east[open].empty()) throw DriveError("no fix while there is truth: say the datum of its frame");
  const Geodetic datum = frame.to_geodetic({quantile(east[open], 0.5), quantile(north[open], 0.5)});
  char text[300];
  std::snprintf(
      text, sizeof text, "truth's datum is not in the bag: taken as %.7f, %.7f from the median of %zu %s",
      datum.latitude_deg, datum.longitude_deg, east[open].size(),
      open != 0 ? "fixes in open sky"
                : "fixes, in open sky or not, which hides what is constant in their error (--datum tells)");
  notices.emplace_back(text);
  return datum;
}

Geodetic choose_datum(const Collector& bag, const std::vector<TruthSample>& truth,
                      const std::optional<Geodetic>& datum, std::vector<std::string>& notices) {
  if (datum) return *datum;
  if (truth.empty()) return bag.fixes().front().point;
  return fitted_datum(bag.fixes(), truth, notices);
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
    rosbag::Bag bag(file);
    const BagTopics found = find_topics(bag, file, topics);
    Collector collector(found);
    for (const rosbag::MessageInstance& message : rosbag::View(bag)) collector.take(message);
    if (collector.twists().size() < 2) throw DriveError(file + ": fewer than two usable odometry messages");
    if (collector.fixes().empty()) throw DriveError(file + ": no usable fix");

    Drive drive;
    drive.name = std::filesystem::path(file).stem().string();
    drive.odometry = increments(collector.twists());
    drive.truth = collector.truth();
    if (found.truth.empty()) drive.notices.emplace_back("no truth topic: nothing is scored");
    if (collector.left_out() > 0) {
      drive.notices.push_back(std::to_string(collector.left_out()) + " unusable messages left out");
    }
    drive.datum = choose_datum(collector, drive.truth, datum, drive.notices);
    const LocalFrame map(drive.datum);
    for (const GeodeticFix& fix : collector.fixes()) {
      drive.fixes.push_back(
          {{fix.stamp, map.to_map(fix.point), fix.covariance, Eigen::Vector2d::Zero()}, fix.arrival});
    }
    return drive;
  } catch (const rosbag::BagException& error) {
    throw DriveError(file + ": " + error.what());
  }
}

}  // namespace multipath_localization
