#include <ros/console.h>

#include <algorithm>

#include "nodes/localization_node.hpp"

/// The part of the node that takes measurements and reports what became of them.
namespace multipath_localization {

void LocalizationNode::on_gnss(const GnssMessage& message) {
  if (!enabled_) return;
  watch_clock();
  reports_.open(to_report(message));
  if (backlog_.take(ros::WallTime::now())) {
    backlog_.count_unweighed();
    return refuse(message, Reason::kOverload);
  }
  if (odometry_) return use(message);
  const auto earlier = early_.find(message.index());
  if (earlier != early_.end()) refuse(earlier->second, Reason::kNotStarted);
  early_.insert_or_assign(message.index(), message);
}

void LocalizationNode::on_unpaired(const sensor_msgs::NavSatFix& fix) {
  if (!enabled_) return;
  FixReport report = to_report(fix);
  report.kind = kGnssKinds[kDualKind];
  const Reason defect = check(fix, parameters_.gnss.fix);
  publish(reports_.numbered(report), refused(defect == Reason::kAccepted ? Reason::kUnpaired : defect));
}

void LocalizationNode::use(const GnssMessage& message) {
  catch_up();
  const Reason reason = hand_over(message);
  if (reason != Reason::kAccepted) refuse(message, reason);
  publish_reports();
  publish_poses();
}

void LocalizationNode::refuse(const GnssMessage& message, Reason reason) {
  const auto report = reports_.close(kGnssKinds[message.index()], header_of(message).stamp.toSec());
  if (report) publish(*report, refused(reason));
}

Reason LocalizationNode::hand_over(const GnssMessage& message) {
  const Reason defect = check(message, parameters_.gnss);
  if (defect != Reason::kAccepted) return defect;
  if (!used_[message.index()]) return Reason::kUnused;
  if (!datum_.map()) {
    const std::optional<Geodetic> place = place_of(message, parameters_.gnss);
    if (place) datum_.add(header_of(message).stamp.toSec(), *place);
    map_services_.tell_origin(header_of(message).stamp);
  }
  if (!datum_.map()) return Reason::kNotStarted;
  const CheckedMeasurement checked =
      to_measurement(message, *datum_.map(), parameters_.gnss,
                     [this](const std::string& frame) { return antenna_in_base(frame); });
  if (checked.reason != Reason::kAccepted) return checked.reason;
  outputs_.publish_fixes(checked.measurement, message);
  localizer_.add(checked.measurement);
  return Reason::kAccepted;
}

std::optional<Eigen::Vector2d> LocalizationNode::antenna_in_base(const std::string& frame) {
  const std::optional<Eigen::Vector2d> antenna = tf_.origin_in_base(frame);
  if (diagnostics_.set_antenna_frame(frame, antenna || !parameters_.gnss.antenna.empty())) {
    ROS_WARN("no transform from %s to %s%s", parameters_.frames.base_link_frame.c_str(),
             tf_.described(frame).c_str(),
             parameters_.gnss.require_antenna_transform ? "" : ": a lone antenna is taken to be at the base");
  }
  return antenna;
}

void LocalizationNode::publish_reports() {
  for (const MeasurementReport& done : localizer_.take_reports()) {
    std::optional<FixReport> report = reports_.close(kGnssKinds[done.measurement.index()], done.stamp);
    if (!report) continue;
    report->usable_satellites = static_cast<std::uint32_t>(satellites_of(done.measurement));
    if (done.observed_sigma) report->observed_sigma = *done.observed_sigma;
    if (done.used_sigma) report->used_sigma = *done.used_sigma;
    publish(*report, done.innovation);
    outputs_.publish_bias(localizer_.estimate(), odometry_stamp());
  }
}

void LocalizationNode::publish(FixReport report, const Innovation& innovation) {
  const auto* const name = std::find(kGnssKinds.begin(), kGnssKinds.end(), report.kind);
  const auto kind = static_cast<std::size_t>(name - kGnssKinds.begin());
  report = concluded(report, innovation, odometry_stamp().toSec());
  gnss_.of(kind).count(innovation.reason);
  diagnostics_.add(report, kind);
  outputs_.publish(report);
}

}  // namespace multipath_localization
