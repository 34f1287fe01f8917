#include "ros/gnss_receiver_node/gnss_receiver_node.hpp"

#include <ros/callback_queue.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "multipath_localization/core/angle.hpp"
#include "rinex/navigation_writer.hpp"
#include "ros/gnss_receiver_node/corrected_epoch_message.hpp"
#include "ros/gnss_receiver_node/driver_messages.hpp"
#include "support/atomic_file.hpp"

namespace multipath_localization {

namespace {

constexpr double kPatience = 0.02;        // for bytes or messages, before anything else is looked after [s]
constexpr double kBetweenSavings = 60.0;  // of ephemerides [s]
constexpr double kLastMessages = 0.5;     // time to leave the queues before the exit [s]
constexpr std::uint32_t kQueue = 100;
constexpr double kGpsEpoch = 315964800.0;  // 6 January 1980, by Unix [s]

PositioningSettings settings_of(const GnssReceiverParameters& parameters) {
  PositioningSettings settings;
  settings.elevation_mask = parameters.elevation_mask_deg * kPi / 180.0;
  for (int i = 0; i < kConstellations; ++i) settings.constellations.insert(static_cast<Constellation>(i));
  return settings;
}

}  // namespace

ros::Time utc_stamp(const GnssTime& time, int leap_seconds) {
  const double whole = std::floor(time.second);
  const auto second = kGpsEpoch + kSecondsOfWeek * time.week + whole - leap_seconds;
  return ros::Time(static_cast<std::uint32_t>(second), 0) + ros::Duration(time.second - whole);
}

GnssReceiverNode::GnssReceiverNode(const ros::NodeHandle& node, const GnssReceiverParameters& parameters)
    : parameters_(parameters),
      node_(node),
      positioning_(settings_of(parameters)),
      receiver_(positioning_.navigation(), [this](const ReceiverEpoch& epoch) { take(epoch); }),
      diagnostics_(parameters.source.empty() ? nullptr : &source_.emplace(parameters.source, parameters.baud),
                   receiver_, positioning_) {
  read_navigation_files();
  if (!parameters_.record_file.empty()) {
    record_.open(parameters_.record_file, std::ios::binary | std::ios::app);
    if (!record_) throw ParameterError("record_file: " + parameters_.record_file + " cannot be written");
  }
  epochs_ = node_.advertise<GnssEpoch>("gnss/epoch", kQueue);
  if (!source_) subscribe();
}

void GnssReceiverNode::read_navigation_files() {
  std::vector<std::string> files;
  if (!parameters_.navigation_file.empty()) files.push_back(parameters_.navigation_file);
  Navigation known = read_navigation(files);
  std::error_code unknown;
  if (std::filesystem::exists(parameters_.ephemeris_file, unknown)) {
    try {
      const Navigation saved = read_navigation({parameters_.ephemeris_file});
      for (const Ephemeris& ephemeris : saved.ephemerides.all()) known.ephemerides.update(ephemeris);
      if (saved.ionosphere) known.ionosphere = saved.ionosphere;
    } catch (const RinexError& error) {
      ROS_WARN("ephemerides that were saved are not used: %s", error.what());
    }
  }
  positioning_.navigation() = known;
  if (!known.ephemerides.all().empty()) ROS_INFO("%zu ephemerides are known", known.ephemerides.all().size());
}

void GnssReceiverNode::subscribe() {
  const auto add = [this](const char* topic, void (GnssReceiverNode::*handler)(const Shifted&)) {
    topics_.push_back(node_.subscribe(topic, kQueue, handler, this, ros::TransportHints().tcpNoDelay()));
  };
  add("rxmraw", &GnssReceiverNode::on_rawx);
  add("rxmsfrb", &GnssReceiverNode::on_sfrbx);
  add("range_meas", &GnssReceiverNode::on_gnss_comm_epoch);
  add("ephem", &GnssReceiverNode::on_gnss_comm_ephemeris);
  add("glo_ephem", &GnssReceiverNode::on_gnss_comm_ephemeris);
}

void GnssReceiverNode::on_rawx(const Shifted& message) {
  const std::optional<std::string> payload = rawx_payload(*message);
  if (!payload) return refuse("rxmraw");
  receiver_.take_rawx(*payload);
}

void GnssReceiverNode::on_sfrbx(const Shifted& message) {
  const std::optional<std::string> payload = sfrbx_payload(*message);
  if (!payload) return refuse("rxmsfrb");
  receiver_.take_sfrbx(*payload);
}

void GnssReceiverNode::on_gnss_comm_epoch(const Shifted& message) {
  const std::optional<RawEpoch> raw = gnss_comm_epoch(*message);
  if (!raw) return refuse("range_meas");
  take({*raw, std::nullopt, false});
}

void GnssReceiverNode::on_gnss_comm_ephemeris(const Shifted& message) {
  const std::optional<Ephemeris> ephemeris = gnss_comm_ephemeris(*message);
  if (!ephemeris) return refuse("ephem or glo_ephem");
  positioning_.navigation().ephemerides.update(*ephemeris);
}

void GnssReceiverNode::refuse(const std::string& topic) {
  ROS_WARN_THROTTLE(10.0, "%s: a message of another version or type", topic.c_str());
  diagnostics_.add_refused(topic);
}

void GnssReceiverNode::spin() {
  while (ros::ok() && !(source_ && source_->ended())) {
    if (source_) {
      take_bytes();
      ros::spinOnce();
    } else {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kPatience));
    }
    diagnostics_.report();
    if ((ros::WallTime::now() - saved_).toSec() > kBetweenSavings) save_ephemerides();
  }
  save_ephemerides();
  if (!ros::ok()) return;
  ROS_INFO("%s: %zu epochs", source_->trouble().c_str(), receiver_.counts().epochs);
  ros::WallDuration(kLastMessages).sleep();
}

void GnssReceiverNode::take_bytes() {
  const std::string bytes = source_->read(kPatience);
  diagnostics_.add_bytes(bytes.size());
  if (record_.is_open()) record_ << bytes << std::flush;
  receiver_.take(bytes);
}

void GnssReceiverNode::take(const ReceiverEpoch& epoch) {
  if (source_ && source_->is_file()) wait_for(epoch.raw.time);
  const ros::Time now = ros::Time::now();
  const ros::Time measured =
      utc_stamp(epoch.raw.time, epoch.leap_seconds.value_or(leap_seconds_at(epoch.raw.time)));
  const std::optional<CorrectedEpoch> corrected = positioning_.correct(epoch.raw);
  const bool live = parameters_.stamps == "receiver" && !(source_ && source_->is_file());
  diagnostics_.add_epoch(live ? (now - measured).toSec() : 0.0, corrected.has_value());
  if (!corrected) {
    ROS_INFO_THROTTLE(5.0, "no epoch: %s", positioning_.standing().shortage.c_str());
    return;
  }
  std_msgs::Header header;
  header.stamp = parameters_.stamps == "receiver" ? measured : now;
  header.frame_id = parameters_.frame;
  epochs_.publish(to_message(*corrected, header));
}

void GnssReceiverNode::wait_for(const GnssTime& time) {
  if (parameters_.rate == 0.0) return;
  if (!first_) {
    first_ = time;
    began_ = ros::WallTime::now();
  }
  const ros::WallTime due = began_ + ros::WallDuration((time - *first_) / parameters_.rate);
  while (ros::ok() && ros::WallTime::now() < due) {
    ros::getGlobalCallbackQueue()->callAvailable(
        std::min(due - ros::WallTime::now(), ros::WallDuration(kPatience)));
    diagnostics_.report();
  }
}

void GnssReceiverNode::save_ephemerides() {
  saved_ = ros::WallTime::now();
  if (parameters_.ephemeris_file.empty()) return;
  writer_.write([file = parameters_.ephemeris_file, text = navigation_text(positioning_.navigation())] {
    try {
      replace_file(file, text);
    } catch (const std::system_error& error) {
      ROS_WARN_THROTTLE(600.0, "ephemerides are not saved: %s", error.what());
    }
  });
}

}  // namespace multipath_localization
