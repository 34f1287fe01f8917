#include "ros/localization_node/gnss_inputs.hpp"

#include <ros/console.h>

#include <algorithm>
#include <utility>

namespace multipath_localization {

namespace {

constexpr std::uint32_t kQueue = 500;
constexpr double kTellEvery = 10.0;    ///< [s]
constexpr unsigned kEnoughToTell = 5;  ///< messages, by which their rate is known

ros::TransportHints at_once() { return ros::TransportHints().tcpNoDelay(); }

}  // namespace

GnssInputs::GnssInputs(ros::NodeHandle node, const GnssParameters& parameters, const UsedKinds& used,
                       Take take, GiveUp give_up)
    : delay_(parameters.delay),
      pairing_(parameters.pair_tolerance),
      take_(std::move(take)),
      give_up_(std::move(give_up)) {
  const auto add = [&](const std::string& name, std::size_t kind, std::vector<ros::Subscriber> subscribers,
                       std::size_t receiver = 0) {
    inputs_.push_back({name, kind, receiver, InputMonitor(name, std::move(subscribers), used[kind])});
  };
  const auto add_lone = [&](std::size_t kind, std::vector<ros::Subscriber> subscribers) {
    add(std::string(kMeasurementNames[kind]), kind, std::move(subscribers));
  };
  for (std::size_t receiver = 0; receiver < kMostReceivers; ++receiver) {
    add(fix_name(receiver), kFixKind, {subscribe_fix(node, receiver)}, receiver);
    level_subscribers_.push_back(subscribe_level(node, receiver));
  }
  add_lone(kDualKind, {node.subscribe("gps/left/fix", kQueue, &GnssInputs::on_left, this, at_once()),
                       node.subscribe("gps/right/fix", kQueue, &GnssInputs::on_right, this, at_once())});
  add_lone(kEpochKind, {node.subscribe("gnss/epoch", kQueue, &GnssInputs::on_epoch, this, at_once())});
  add_lone(kVelocityKind,
           {node.subscribe("gps/velocity", kQueue, &GnssInputs::on_velocity, this, at_once())});
  add_lone(kHeadingKind, {node.subscribe("heading", kQueue, &GnssInputs::on_heading, this, at_once())});
}

ros::Subscriber GnssInputs::subscribe_fix(ros::NodeHandle& node, std::size_t receiver) {
  return node.subscribe<sensor_msgs::NavSatFix>(
      fix_topic(receiver), kQueue,
      [this, receiver](const sensor_msgs::NavSatFix::ConstPtr& message) {
        of(fix_name(receiver)).arrived();
        ReceiverFix fix(stamped_earlier(*message, delay_), receiver);
        fix.level = levels_[receiver].at(message->header.stamp.toSec());
        take_(fix);
      },
      ros::VoidConstPtr(), at_once());
}

ros::Subscriber GnssInputs::subscribe_level(ros::NodeHandle& node, std::size_t receiver) {
  const std::string topic = level_topic(receiver);
  return node.subscribe<topic_tools::ShapeShifter>(
      topic, kQueue,
      [this, receiver, topic](const topic_tools::ShapeShifter::ConstPtr& message) {
        const std::optional<ToldLevel> told = level_of(*message);
        if (!told) return;
        levels_[receiver].add(*told);
        if (told_.insert(topic).second) ROS_INFO("%s: levels of fixes are told apart", topic.c_str());
      },
      ros::VoidConstPtr(), at_once());
}

InputMonitor& GnssInputs::of(std::string_view name) {
  return std::find_if(inputs_.begin(), inputs_.end(),
                      [&](const GnssInput& input) { return input.name == name; })
      ->monitor;
}

void GnssInputs::on_left(const sensor_msgs::NavSatFix::ConstPtr& message) {
  add(FixPairing::Side::kLeft, *message);
}

void GnssInputs::on_right(const sensor_msgs::NavSatFix::ConstPtr& message) {
  add(FixPairing::Side::kRight, *message);
}

void GnssInputs::on_epoch(const GnssEpoch::ConstPtr& message) {
  of(kMeasurementNames[kEpochKind]).arrived();
  take_(stamped_earlier(*message, delay_));
}

void GnssInputs::on_velocity(const topic_tools::ShapeShifter::ConstPtr& message) {
  if (const auto velocity = velocity_of(*message)) {
    of(kMeasurementNames[kVelocityKind]).arrived();
    take_(stamped_earlier(*velocity, delay_));
  } else {
    ROS_WARN_THROTTLE(kTellEvery, "gps/velocity is a %s: neither TwistWithCovarianceStamped nor TwistStamped",
                      message->getDataType().c_str());
  }
}

void GnssInputs::on_heading(const topic_tools::ShapeShifter::ConstPtr& message) {
  if (const auto heading = heading_of(*message)) {
    of(kMeasurementNames[kHeadingKind]).arrived();
    take_(stamped_earlier(*heading, delay_));
  } else {
    ROS_WARN_THROTTLE(kTellEvery, "heading is a %s: neither Imu nor PoseWithCovarianceStamped",
                      message->getDataType().c_str());
  }
}

void GnssInputs::add(FixPairing::Side side, const sensor_msgs::NavSatFix& fix) {
  of(kMeasurementNames[kDualKind]).arrived();
  const FixPairing::Outcome outcome = pairing_.add(side, stamped_earlier(fix, delay_));
  for (const sensor_msgs::NavSatFix& unpaired : outcome.unpaired) give_up_(unpaired);
  if (outcome.pair) take_(*outcome.pair);
}

void GnssInputs::clear() {
  for (const sensor_msgs::NavSatFix& unpaired : pairing_.clear()) give_up_(unpaired);
}

std::string GnssInputs::described() const {
  std::string text;
  for (const GnssInput& input : inputs_) {
    if (input.counts() && input.tells_position()) {
      text += (text.empty() ? "" : " or ") + input.monitor.described();
    }
  }
  return text;
}

bool GnssInputs::silent(double bound) const {
  return std::all_of(inputs_.begin(), inputs_.end(), [&](const GnssInput& input) {
    return !input.counts() || !input.tells_position() || input.monitor.silent(bound);
  });
}

void GnssInputs::tell_new() {
  for (const GnssInput& input : inputs_) {
    if (input.monitor.tally().of(Reason::kAccepted) < kEnoughToTell || !told_.insert(input.name).second)
      continue;
    ROS_INFO("%s: used, %.1f Hz", input.monitor.described().c_str(), input.monitor.frequency());
  }
}

std::vector<std::string> GnssInputs::sums() const {
  std::vector<std::string> all;
  for (const GnssInput& input : inputs_) {
    if (const std::string sum = input.monitor.sum(); !sum.empty()) all.push_back(sum);
  }
  return all;
}

}  // namespace multipath_localization
