#include "ros/bags/bag_collector.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Vector3Stamped.h>

#include <algorithm>
#include <utility>

#include "ros/map/datum.hpp"
#include "ros/map/datum_search.hpp"
#include "ros/messages/earth_frame.hpp"

namespace multipath_localization {

void BagCollector::take(const rosbag::MessageInstance& message) {
  const std::string& topic = message.getTopic();
  const bool is_static = without_slash(topic) == "tf_static";
  if (is_static || without_slash(topic) == "tf") add(read<tf2_msgs::TFMessage>(message), is_static);
  if (topic == topics_.odometry) add(read<nav_msgs::Odometry>(message));
  if (topic == topics_.truth) take_truth(message);
  if (topic == topics_.shadow) {
    const auto bias = read<geometry_msgs::Vector3Stamped>(message);
    shadows_[bias.header.stamp.toSec()] = bias.vector.z > 0.5;
  }
  if (topic == topics_.imu) add(read<sensor_msgs::Imu>(message));
  if (topic == topics_.velocity || topic == topics_.heading) take_by_type(message);
  if (topic == topics_.fix) add(GnssMessage(ReceiverFix(read<sensor_msgs::NavSatFix>(message))));
  const auto more = std::find(topics_.more_fixes.begin(), topics_.more_fixes.end(), topic);
  if (more != topics_.more_fixes.end()) {
    const auto receiver = static_cast<std::size_t>(more - topics_.more_fixes.begin()) + 1;
    add(GnssMessage(ReceiverFix(read<sensor_msgs::NavSatFix>(message), receiver)));
  }
  if (topic == topics_.epoch) add(read<GnssEpoch>(message));
  if (topic == topics_.left) add(FixPairing::Side::kLeft, read<sensor_msgs::NavSatFix>(message));
  if (topic == topics_.right) add(FixPairing::Side::kRight, read<sensor_msgs::NavSatFix>(message));
}

template <class Message>
Message BagCollector::read(const rosbag::MessageInstance& message) const {
  if (const auto known = message.instantiate<Message>()) return *known;
  const std::string wanted = ros::message_traits::datatype<Message>();
  const std::string is = file_ + ": " + message.getTopic() + " is a " + message.getDataType();
  throw DriveError(message.getDataType() == wanted ? is + " of another version" : is + ", not a " + wanted);
}

void BagCollector::finish() {
  for (const sensor_msgs::NavSatFix& fix : pairing_.clear()) give_up(fix);
}

std::vector<TruthSample> BagCollector::truth() const {
  std::vector<TruthSample> samples;
  for (const auto& [stamp, base_in_map] : truth_) {
    samples.push_back({stamp, base_in_map, turns_, std::nullopt});
    const auto later = shadows_.upper_bound(stamp);
    if (shadows_.empty()) continue;
    samples.back().shadow = later == shadows_.begin() ? later->second : std::prev(later)->second;
  }
  return samples;
}

std::optional<Geodetic> BagCollector::datum() const {
  const std::optional<Eigen::Isometry3d> map = antennas_.pose(truth_frame_, kEarthFrame);
  return map ? datum_of(*map) : std::nullopt;
}

std::vector<std::string> BagCollector::refusals() const {
  std::vector<std::string> all;
  for (const auto& [refusal, times] : refusals_) {
    all.push_back(refusal + ", " + std::to_string(times) + " times");
  }
  return all;
}

std::string BagCollector::all_refusals() const {
  std::string all;
  for (const std::string& refusal : refusals()) all += (all.empty() ? " (" : "; ") + refusal;
  return all.empty() ? "" : all + ")";
}

void BagCollector::add(const nav_msgs::Odometry& message) {
  odometry_in_map_ =
      odometry_in_map_ || without_slash(message.header.frame_id) == FrameParameters().map_frame;
  const CheckedOdometry checked = reader_.read(message);
  if (!passes(topics_.odometry, checked.reason)) return;
  if (checked.restarted) note_restart(checked.increment.stamp);
  odometry_.push_back(checked.increment);
  antennas_.set_frames({FrameParameters().map_frame, without_slash(message.header.frame_id),
                        without_slash(message.child_frame_id)});
}

void BagCollector::add(const sensor_msgs::Imu& message) {
  const CheckedYawRate checked = imu_.read(message);
  if (!passes(topics_.imu, checked.reason)) return;
  yaw_rates_.push_back({checked.yaw_rate, arrival(checked.yaw_rate.stamp)});
}

void BagCollector::take_by_type(const rosbag::MessageInstance& message) {
  const std::string& type = message.getDataType();
  if (type == ros::message_traits::datatype<geometry_msgs::TwistStamped>()) {
    add(GnssMessage(without_covariance(read<geometry_msgs::TwistStamped>(message))));
  } else if (type == ros::message_traits::datatype<sensor_msgs::Imu>()) {
    add(GnssMessage(read<sensor_msgs::Imu>(message)));
  } else if (type == ros::message_traits::datatype<geometry_msgs::PoseWithCovarianceStamped>()) {
    add(GnssMessage(orientation_alone(read<geometry_msgs::PoseWithCovarianceStamped>(message))));
  } else {
    add(GnssMessage(read<geometry_msgs::TwistWithCovarianceStamped>(message)));
  }
}

double BagCollector::arrival(double stamp) const {
  return odometry_.empty() ? stamp : odometry_.back().stamp;
}

void BagCollector::note_restart(double stamp) {
  if (odometry_.empty()) return;
  const double last = odometry_.back().stamp;
  if (stamp < last) {
    throw DriveError(file_ + ": " + topics_.odometry + " goes back in time, from " + std::to_string(last) +
                     " to " + std::to_string(stamp) + ": cut the bag there with rosbag filter");
  }
  silences_.push_back({last, stamp});
}

void BagCollector::add(const GnssMessage& message) {
  const Reason defect = check(message, {});
  if (defect != Reason::kAccepted) return refuse(message.index(), defect);
  const double stamp = header_of(message).stamp.toSec();
  for (const std::string& frame : frames_of(message))
    antennas_.in_base(frame);  // which sees whether it moves
  received_.push_back({message, arrival(stamp)});
}

void BagCollector::add(FixPairing::Side side, const sensor_msgs::NavSatFix& fix) {
  const FixPairing::Outcome outcome = pairing_.add(side, fix);
  for (const sensor_msgs::NavSatFix& unpaired : outcome.unpaired) give_up(unpaired);
  if (outcome.pair) add(GnssMessage(*outcome.pair));
}

void BagCollector::add(const tf2_msgs::TFMessage& message, bool is_static) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    antennas_.add(transform, is_static);
  }
}

void BagCollector::take_truth(const rosbag::MessageInstance& message) {
  if (message.getDataType() == ros::message_traits::datatype<nav_msgs::Odometry>()) {
    const auto odometry = read<nav_msgs::Odometry>(message);
    return add_truth(odometry.header, odometry.pose.pose);
  }
  const auto pose = read<geometry_msgs::PoseStamped>(message);
  add_truth(pose.header, pose.pose);
}

void BagCollector::add_truth(const std_msgs::Header& header, const geometry_msgs::Pose& message) {
  const std::optional<Pose2> pose = to_pose2(message);
  if (!passes(topics_.truth, pose ? Reason::kAccepted : Reason::kInvalidPosition)) return;
  turns_ = turns_ || pose->yaw != 0.0;
  truth_[header.stamp.toSec()] = *pose;
  truth_frame_ = without_slash(header.frame_id);
}

void BagCollector::give_up(const sensor_msgs::NavSatFix& fix) {
  const Reason defect = check(fix, FixParameters{});
  refuse(kDualKind, defect == Reason::kAccepted ? Reason::kUnpaired : defect);
}

void BagCollector::refuse(std::size_t kind, Reason reason) {
  passes(topic_of(kind), reason);
  left_out_[kind].count(reason);
}

Geodetic BagCollector::find_datum() {
  DatumSearch search({}, OdometryParameters{}.max_speed, 0.0);
  std::vector<ReceivedMessage> kept;
  std::size_t next = 0;  // to be decided on
  std::optional<Geodetic> found;
  for (const ReceivedMessage& received : received_) {
    const std::vector<DatumSearch::Decided> decided = search.add(received.message);
    if (found && distance(*found, *search.place()) > 0.0) {
      for (const ReceivedMessage& nonsense : std::exchange(kept, {})) {
        refuse(nonsense.message.index(), Reason::kInvalidPosition);
      }
    }
    found = search.place();
    for (const auto& [message, reason] : decided) {
      const double arrival = received_[next++].arrival;
      if (reason == Reason::kAccepted)
        kept.push_back({message, arrival});
      else
        refuse(message.index(), reason);
    }
  }
  for (const GnssMessage& message : search.take_waiting()) refuse(message.index(), Reason::kInvalidPosition);
  if (!found)
    throw DriveError(file_ + ": no three measurements agree on a place for a datum" + all_refusals());
  received_ = kept;
  return *found;
}

bool BagCollector::passes(const std::string& topic, Reason reason) {
  if (reason == Reason::kAccepted) return true;
  ++refusals_[topic + ": " + std::string(to_string(reason))];
  return false;
}

std::string BagCollector::topic_of(std::size_t kind) const {
  if (kind == kFixKind) return topics_.fix;
  if (kind == kVelocityKind) return topics_.velocity;
  if (kind == kHeadingKind) return topics_.heading;
  return kind == kEpochKind ? topics_.epoch : topics_.left + " and " + topics_.right;
}

}  // namespace multipath_localization
