#include "ros/messages/drive_messages.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "ros/messages/conversions.hpp"
#include "ros/messages/earth_frame.hpp"
#include "ros/messages/epoch_conversions.hpp"
#include "ros/messages/gnss_message.hpp"
#include "ros/messages/heading_conversions.hpp"
#include "ros/messages/imu_conversions.hpp"
#include "ros/messages/velocity_conversions.hpp"

namespace multipath_localization {

std::vector<DriveEvent> events_of(const Drive& drive) {
  std::vector<DriveEvent> events;
  for (const RecordedYawRate& recorded : drive.yaw_rates) events.push_back({recorded.arrival, &recorded});
  for (const OdometryIncrement& increment : drive.odometry) events.push_back({increment.stamp, &increment});
  for (const RecordedMeasurement& recorded : drive.measurements)
    events.push_back({recorded.arrival, &recorded});
  for (const TruthSample& truth : drive.truth) events.push_back({truth.stamp, &truth});
  std::stable_sort(events.begin(), events.end(),
                   [](const DriveEvent& a, const DriveEvent& b) { return a.time < b.time; });
  return events;
}

DriveMessages::DriveMessages(const Geodetic& datum, const RobotFrames& frames, Clock stamp_of)
    : map_(datum), frames_(frames), stamp_of_(std::move(stamp_of)) {}

tf2_msgs::TFMessage DriveMessages::static_transforms(const Drive& drive) const {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  message.transforms.front().header = header(drive.start(), kEarthFrame);
  message.transforms.front().child_frame_id = frames_.map_frame;
  message.transforms.front().transform = map_in_earth(map_);
  std::set<std::string> placed;
  for (const RecordedMeasurement& recorded : drive.measurements) {
    if (!placed.insert(name_of(recorded.measurement)).second) continue;
    for (geometry_msgs::TransformStamped& antenna : antennas_of(recorded.measurement)) {
      antenna.header = header(drive.start(), frames_.base_link_frame);
      message.transforms.push_back(antenna);
    }
  }
  return message;
}

std::vector<geometry_msgs::TransformStamped> DriveMessages::antennas_of(
    const Measurement& measurement) const {
  std::vector<geometry_msgs::TransformStamped> antennas;
  const auto place = [&](const std::string& frame, const Eigen::Vector2d& in_base) {
    antennas.emplace_back();
    antennas.back().child_frame_id = frame;
    antennas.back().transform = to_transform(Pose2{in_base.x(), in_base.y(), 0.0});
  };
  if (const auto* fix = std::get_if<GnssFix>(&measurement)) {
    place(frames_.fix_frame(fix->receiver), fix->antenna_in_base);
  }
  if (const auto* pair = std::get_if<DualAntennaFix>(&measurement)) {
    place(frames_.gps_left_frame, pair->left.antenna_in_base);
    place(frames_.gps_right_frame, pair->right.antenna_in_base);
  }
  if (const auto* epoch = std::get_if<PseudorangeEpoch>(&measurement)) {
    place(frames_.gps_frame, epoch->antenna_in_base);
  }
  return antennas;
}

std::vector<TopicMessage> DriveMessages::of(const DriveEvent& event) {
  if (const auto* increment = std::get_if<const OdometryIncrement*>(&event.what)) return {of(**increment)};
  if (const auto* truth = std::get_if<const TruthSample*>(&event.what)) return of(**truth);
  if (const auto* recorded = std::get_if<const RecordedYawRate*>(&event.what)) {
    const YawRate& yaw_rate = (*recorded)->yaw_rate;
    return {{"imu/data", to_message(yaw_rate, header(yaw_rate.stamp, frames_.base_link_frame))}};
  }
  return of(std::get<const RecordedMeasurement*>(event.what)->measurement);
}

TopicMessage DriveMessages::of(const OdometryIncrement& increment) {
  base_in_odom_ = base_in_odom_ * displacement(increment);
  nav_msgs::Odometry message;
  message.header = header(increment.stamp, frames_.odom_frame);
  message.child_frame_id = frames_.base_link_frame;
  message.pose.pose = to_message(base_in_odom_);
  message.twist.twist.linear.x = increment.speed;
  message.twist.twist.linear.y = increment.lateral_speed;
  message.twist.twist.angular.z = increment.yaw_rate;
  return {"odom", message};
}

std::vector<TopicMessage> DriveMessages::of(const Measurement& measurement) const {
  if (const auto* fix = std::get_if<GnssFix>(&measurement)) {
    const std_msgs::Header own = header(fix->stamp, frames_.fix_frame(fix->receiver));
    return {{fix_topic(fix->receiver), to_message(*fix, map_, own)}};
  }
  if (const auto* epoch = std::get_if<PseudorangeEpoch>(&measurement)) {
    return {{"gnss/epoch", to_message(*epoch, map_, header(epoch->stamp, frames_.gps_frame))}};
  }
  if (const auto* velocity = std::get_if<GnssVelocity>(&measurement)) {
    return {{"gps/velocity", to_message(*velocity, header(velocity->stamp, frames_.gps_frame))}};
  }
  if (const auto* heading = std::get_if<Heading>(&measurement)) {
    return {{"heading", to_message(*heading, header(heading->stamp, frames_.base_link_frame))}};
  }
  const auto& [stamp, left, right] = std::get<DualAntennaFix>(measurement);
  return {{"gps/left/fix", to_message(left, map_, header(left.stamp, frames_.gps_left_frame))},
          {"gps/right/fix", to_message(right, map_, header(right.stamp, frames_.gps_right_frame))}};
}

std::vector<TopicMessage> DriveMessages::of(const TruthSample& truth) const {
  nav_msgs::Odometry message;
  message.header = header(truth.stamp, frames_.map_frame);
  message.child_frame_id = frames_.base_link_frame;
  message.pose.pose = to_message(truth.base_in_map);
  if (!truth.shadow) return {{"truth", message}};
  geometry_msgs::Vector3Stamped bias;
  bias.header = message.header;
  bias.vector.z = *truth.shadow ? 1.0 : 0.0;
  return {{"truth", message}, {"truth/bias", bias}};
}

std_msgs::Header DriveMessages::header(double time, const std::string& frame) const {
  std_msgs::Header message;
  message.stamp = stamp_of_(time);
  message.frame_id = frame;
  return message;
}

}  // namespace multipath_localization
