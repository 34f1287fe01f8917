#include "ros/localization_node/gnss_pipeline.hpp"

#include <ros/console.h>

#include <algorithm>
#include <utility>

#include "ros/localization_node/estimate_messages.hpp"

namespace multipath_localization {

GnssPipeline::GnssPipeline(ros::NodeHandle node, const UsedKinds& used, const Parts& parts, Hooks hooks)
    : parts_(parts),
      hooks_(std::move(hooks)),
      used_(used),
      antennas_(parts.tf.antennas(), parts.parameters.gnss),
      inputs_(
          node, parts.parameters.gnss, used, [this](const GnssMessage& message) { on_message(message); },
          [this](const sensor_msgs::NavSatFix& fix) { on_unpaired(fix); }) {}

void GnssPipeline::on_message(const GnssMessage& message) {
  if (!parts_.enabled) return;
  hooks_.watch_clock();
  reports_.open(to_report(message));
  if (parts_.backlog.take(ros::WallTime::now())) {
    parts_.backlog.count_unweighed();
    return refuse(message, Reason::kOverload);
  }
  if (parts_.odometry.last()) return use(message);
  const std::string name = name_of(message);
  const auto earlier = early_.find(name);
  if (earlier != early_.end()) refuse(earlier->second, Reason::kNotStarted);
  early_.insert_or_assign(name, message);
}

void GnssPipeline::on_unpaired(const sensor_msgs::NavSatFix& fix) {
  if (!parts_.enabled) return;
  FixReport report = to_report(ReceiverFix(fix));
  report.kind = kMeasurementNames[kDualKind];
  const Reason defect = check(fix, parts_.parameters.gnss.fix);
  publish(reports_.numbered(report), refused(defect == Reason::kAccepted ? Reason::kUnpaired : defect));
}

void GnssPipeline::use_early() {
  for (const auto& [name, early] : std::exchange(early_, {})) use(early);
}

void GnssPipeline::use(const GnssMessage& message) {
  hooks_.catch_up();
  admit(message);
  publish_done();
  hooks_.answer();
}

void GnssPipeline::refuse(const GnssMessage& message, Reason reason, const std::string& detail) {
  const auto report = reports_.close(name_of(message), header_of(message).stamp.toSec());
  if (report) publish(*report, refused(reason), detail);
}

void GnssPipeline::admit(const GnssMessage& message) {
  const Reason defect = check(message, parts_.parameters.gnss);
  if (defect != Reason::kAccepted) return refuse(message, defect);
  if (!used_[message.index()]) return refuse(message, Reason::kUnused);
  const Datum::Admission admission = parts_.datum.admit(message);
  parts_.map_services.tell_origin(header_of(message).stamp);
  if (admission.moved)
    return hooks_.restart("the first fixes were far from those that followed, and so was the datum");
  for (const auto& [decided, reason] : admission.decided) {
    reason == Reason::kAccepted ? weigh(decided) : refuse(decided, reason);
  }
}

void GnssPipeline::weigh(const GnssMessage& message) {
  if (antennas_.appeared(message))
    return hooks_.restart("tf has placed an antenna that was taken to be elsewhere");
  const double now = parts_.odometry.stamp().toSec();
  if (antennas_.waits(message, now, ros::WallTime::now().toSec())) return unplaced_.push_back(message);
  const GnssParameters& gnss = parts_.parameters.gnss;
  const double stamp = header_of(message).stamp.toSec();
  const CheckedMeasurement checked = to_measurement(
      message, *parts_.datum.map(), gnss,
      [&](const std::string& frame) { return antenna_in_base(frame, stamp); },
      [this](const std::string& frame) { return parts_.tf.antennas().rotation_in_base(frame); });
  if (checked.reason == Reason::kInvalidPosition) {
    const std::optional<Geodetic> place = place_of(message, gnss);
    return refuse(message, checked.reason, place ? parts_.datum.distance_to(*place) : "");
  }
  if (checked.reason != Reason::kAccepted) return refuse(message, checked.reason);
  antennas_.assume(message);
  parts_.outputs.publish_fixes(checked.measurement, message);
  parts_.localizer.add(checked.measurement);
}

void GnssPipeline::weigh_waiting() {
  if (unplaced_.empty()) return;
  hooks_.catch_up();
  for (const GnssMessage& message : std::exchange(unplaced_, {})) weigh(message);
  publish_done();
  hooks_.answer();
}

std::optional<Eigen::Vector2d> GnssPipeline::antenna_in_base(const std::string& frame, double stamp) {
  const LocalizationParameters& parameters = parts_.parameters;
  const std::optional<Eigen::Vector2d> antenna = parts_.tf.antennas().in_base(frame);
  if (parts_.diagnostics.set_antenna_frame(frame, antenna || !parameters.gnss.antenna.empty())) {
    ROS_WARN("no transform from %s to %s%s", parameters.frames.base_link_frame.c_str(),
             parts_.tf.antennas().described(frame).c_str(), parameters.gnss.otherwise_at().c_str());
  }
  if (!antenna) return std::nullopt;
  const double height = parts_.tf.antennas().height_in_base(frame);
  return levelled(parts_.tilt.at(stamp), {antenna->x(), antenna->y(), height});
}

void GnssPipeline::publish_done() {
  for (const MeasurementReport& done : parts_.localizer.take_reports()) {
    std::optional<FixReport> report = reports_.close(name_of(done.measurement), done.stamp);
    if (!report) continue;
    report->usable_satellites = static_cast<std::uint32_t>(satellites_of(done.measurement));
    if (done.observed_sigma) report->observed_sigma = *done.observed_sigma;
    if (done.used_sigma) report->used_sigma = *done.used_sigma;
    publish(*report, done.innovation);
    parts_.outputs.publish_bias(parts_.localizer.estimate(), parts_.odometry.stamp());
  }
}

void GnssPipeline::publish(FixReport report, const Innovation& innovation, const std::string& detail) {
  report = concluded(report, innovation, parts_.odometry.stamp().toSec());
  InputMonitor& input = inputs_.of(report.kind);
  input.count(innovation.reason, detail);
  parts_.diagnostics.add(report);
  if (const std::string why = input.complaint(); !why.empty()) ROS_WARN("%s", why.c_str());
  parts_.outputs.publish(report);
}

void GnssPipeline::restart() {
  early_.clear();
  unplaced_.clear();
  parts_.datum.drop_waiting();
  inputs_.clear();
  while (const auto left = reports_.close_oldest()) publish(*left, refused(Reason::kNotStarted));
}

}  // namespace multipath_localization
