#include "nodes/bag_writer.hpp"

#include <geometry_msgs/Vector3Stamped.h>
#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "nodes/conversions.hpp"
#include "nodes/earth_frame.hpp"
#include "nodes/epoch_conversions.hpp"

namespace multipath_localization {

namespace {

constexpr char kMap[] = "map", kOdom[] = "odom", kBase[] = "base_link";
constexpr char kAntenna[] = "gps", kLeftAntenna[] = "gps_left", kRightAntenna[] = "gps_right";

geometry_msgs::TransformStamped antenna(const char* frame, const Eigen::Vector2d& in_base) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = kBase;
  transform.child_frame_id = frame;
  transform.transform = to_transform(Pose2{in_base.x(), in_base.y(), 0.0});
  return transform;
}

/// The antennas of one measurement as static transforms.
struct Antennas {
  std::vector<geometry_msgs::TransformStamped> operator()(const GnssFix& fix) const {
    return {antenna(kAntenna, fix.antenna_in_base)};
  }
  std::vector<geometry_msgs::TransformStamped> operator()(const DualAntennaFix& fixes) const {
    return {antenna(kLeftAntenna, fixes.left.antenna_in_base),
            antenna(kRightAntenna, fixes.right.antenna_in_base)};
  }
  std::vector<geometry_msgs::TransformStamped> operator()(const PseudorangeEpoch& epoch) const {
    return {antenna(kAntenna, epoch.antenna_in_base)};
  }
};

class BagWriter {
 public:
  BagWriter(const Drive& drive, const std::string& file)
      : bag_(file, rosbag::bagmode::Write), map_(drive.datum), shift_(drive.start() < 1.0 ? 1.0 : 0.0) {}

  void write_transforms(const Drive& drive) {
    tf2_msgs::TFMessage message;
    message.transforms.resize(1);
    message.transforms.front().header.frame_id = kEarthFrame;
    message.transforms.front().child_frame_id = kMap;
    message.transforms.front().transform = map_in_earth(map_);
    std::array<bool, std::variant_size_v<Measurement>> placed{};
    for (const RecordedMeasurement& recorded : drive.measurements) {
      if (std::exchange(placed[recorded.measurement.index()], true)) continue;
      const auto antennas = std::visit(Antennas{}, recorded.measurement);
      message.transforms.insert(message.transforms.end(), antennas.begin(), antennas.end());
    }
    write("/tf_static", drive.start(), message);
  }

  void write(const OdometryIncrement& increment) {
    base_in_odom_ = base_in_odom_ * displacement(increment);
    nav_msgs::Odometry message;
    message.header = header(increment.stamp, kOdom);
    message.child_frame_id = kBase;
    message.pose.pose = to_message(base_in_odom_);
    message.twist.twist.linear.x = increment.speed;
    message.twist.twist.angular.z = increment.yaw_rate;
    write("/odom", increment.stamp, message);
  }

  void write(const RecordedMeasurement& recorded) {
    std::visit([&](const auto& m) { this->write(m, recorded.arrival); }, recorded.measurement);
  }

  void write(const TruthSample& truth) {
    nav_msgs::Odometry message;
    message.header = header(truth.stamp, kMap);
    message.child_frame_id = kBase;
    message.pose.pose = to_message(truth.base_in_map);
    write("/truth", truth.stamp, message);
    if (!truth.shadow) return;
    geometry_msgs::Vector3Stamped bias;
    bias.header = message.header;
    bias.vector.z = *truth.shadow ? 1.0 : 0.0;
    write("/truth/bias", truth.stamp, bias);
  }

 private:
  void write(const GnssFix& fix, double arrival) {
    write("/gps/fix", arrival, to_message(fix, map_, header(fix.stamp, kAntenna)));
  }

  void write(const DualAntennaFix& fixes, double arrival) {
    write("/gps/left/fix", arrival, to_message(fixes.left, map_, header(fixes.left.stamp, kLeftAntenna)));
    write("/gps/right/fix", arrival, to_message(fixes.right, map_, header(fixes.right.stamp, kRightAntenna)));
  }

  void write(const PseudorangeEpoch& epoch, double arrival) {
    write("/gnss/epoch", arrival, to_message(epoch, map_, header(epoch.stamp, kAntenna)));
  }

  /// Records a message after all those before: a reader may take those of one time in any order.
  template <class Message>
  void write(const char* topic, double time, const Message& message) {
    last_ = std::max(ros::Time(time + shift_), last_ + ros::Duration(0, 1));
    bag_.write(topic, last_, message);
  }

  [[nodiscard]] std_msgs::Header header(double stamp, const char* frame) const {
    std_msgs::Header message;
    message.stamp = ros::Time(stamp + shift_);
    message.frame_id = frame;
    return message;
  }

  rosbag::Bag bag_;
  LocalFrame map_;
  double shift_;
  ros::Time last_;
  Pose2 base_in_odom_;
};

/// Writes all three streams by time; of one time odometry first, truth last, as `run_drive` takes them.
void write_streams(const Drive& drive, BagWriter& writer) {
  std::vector<std::pair<double, std::function<void()>>> events;
  for (const OdometryIncrement& o : drive.odometry) events.emplace_back(o.stamp, [&] { writer.write(o); });
  for (const RecordedMeasurement& m : drive.measurements) {
    events.emplace_back(m.arrival, [&] { writer.write(m); });
  }
  for (const TruthSample& t : drive.truth) events.emplace_back(t.stamp, [&] { writer.write(t); });
  std::stable_sort(events.begin(), events.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [time, write] : events) write();
}

}  // namespace

void write_bag(const Drive& drive, const std::string& file) {
  try {
    BagWriter writer(drive, file);
    writer.write_transforms(drive);
    write_streams(drive, writer);
  } catch (const std::exception& error) {
    throw DriveError(file + ": " + error.what());
  }
}

}  // namespace multipath_localization
