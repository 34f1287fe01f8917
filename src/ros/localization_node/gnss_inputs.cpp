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
      give_up_(std::move(give_up)),
      monitors_{
          InputMonitor("fix", {node.subscribe("gps/fix", kQueue, &GnssInputs::on_fix, this, at_once())},
                       used[kFixKind]),
          InputMonitor("dual",
                       {node.subscribe("gps/left/fix", kQueue, &GnssInputs::on_left, this, at_once()),
                        node.subscribe("gps/right/fix", kQueue, &GnssInputs::on_right, this, at_once())},
                       used[kDualKind]),
          InputMonitor("epoch",
                       {node.subscribe("gnss/epoch", kQueue, &GnssInputs::on_epoch, this, at_once())},
                       used[kEpochKind]),
          InputMonitor("velocity",
                       {node.subscribe("gps/velocity", kQueue, &GnssInputs::on_velocity, this, at_once())},
                       used[kVelocityKind])} {}

void GnssInputs::on_fix(const sensor_msgs::NavSatFix::ConstPtr& message) {
  of(kFixKind).arrived();
  take_(stamped_earlier(*message, delay_));
}

void GnssInputs::on_left(const sensor_msgs::NavSatFix::ConstPtr& message) {
  add(FixPairing::Side::kLeft, *message);
}

void GnssInputs::on_right(const sensor_msgs::NavSatFix::ConstPtr& message) {
  add(FixPairing::Side::kRight, *message);
}

void GnssInputs::on_epoch(const GnssEpoch::ConstPtr& message) {
  of(kEpochKind).arrived();
  take_(stamped_earlier(*message, delay_));
}

void GnssInputs::on_velocity(const topic_tools::ShapeShifter::ConstPtr& message) {
  if (const auto velocity = velocity_of(*message)) {
    of(kVelocityKind).arrived();
    take_(stamped_earlier(*velocity, delay_));
  } else {
    ROS_WARN_THROTTLE(kTellEvery, "gps/velocity is a %s: neither TwistWithCovarianceStamped nor TwistStamped",
                      message->getDataType().c_str());
  }
}

void GnssInputs::add(FixPairing::Side side, const sensor_msgs::NavSatFix& fix) {
  of(kDualKind).arrived();
  const FixPairing::Outcome outcome = pairing_.add(side, stamped_earlier(fix, delay_));
  for (const sensor_msgs::NavSatFix& unpaired : outcome.unpaired) give_up_(unpaired);
  if (outcome.pair) take_(*outcome.pair);
}

void GnssInputs::clear() {
  for (const sensor_msgs::NavSatFix& unpaired : pairing_.clear()) give_up_(unpaired);
}

std::string GnssInputs::described() const {
  std::string text;
  for (const InputMonitor& monitor : monitors_) {
    if (monitor.awaited() && &monitor != &of(kVelocityKind))
      text += (text.empty() ? "" : " or ") + monitor.described();
  }
  return text;
}

bool GnssInputs::silent(double bound) const {
  return std::all_of(monitors_.begin(), monitors_.end(), [&](const InputMonitor& monitor) {
    return !monitor.awaited() || &monitor == &of(kVelocityKind) || monitor.silent(bound);
  });
}

void GnssInputs::tell_new() {
  for (std::size_t kind = 0; kind < monitors_.size(); ++kind) {
    if (told_[kind] || monitors_[kind].tally().of(Reason::kAccepted) < kEnoughToTell) continue;
    told_[kind] = true;
    ROS_INFO("%s: used, %.1f Hz", monitors_[kind].described().c_str(), monitors_[kind].frequency());
  }
}

std::vector<std::string> GnssInputs::sums() const {
  std::vector<std::string> all;
  for (const InputMonitor& monitor : monitors_) {
    if (const std::string sum = monitor.sum(); !sum.empty()) all.push_back(sum);
  }
  return all;
}

}  // namespace multipath_localization
