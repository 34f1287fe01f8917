#include <ros/console.h>

#include <algorithm>
#include <utility>

#include "ros/localization_node/localization_node.hpp"

/// The part of the node that takes measurements and reports what became of them.
namespace multipath_localization {

namespace {

constexpr double kSameAntenna = 0.05;      ///< two places of one are the same within this [m]
constexpr std::size_t kMostAssumed = 100;  ///< frames

}  // namespace

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
  admit(message);
  publish_reports();
  publish_poses();
}

void LocalizationNode::refuse(const GnssMessage& message, Reason reason, const std::string& detail) {
  const auto report = reports_.close(kGnssKinds[message.index()], header_of(message).stamp.toSec());
  if (report) publish(*report, refused(reason), detail);
}

void LocalizationNode::admit(const GnssMessage& message) {
  const Reason defect = check(message, parameters_.gnss);
  if (defect != Reason::kAccepted) return refuse(message, defect);
  if (!used_[message.index()]) return refuse(message, Reason::kUnused);
  const Datum::Admission admission = datum_.admit(message);
  map_services_.tell_origin(header_of(message).stamp);
  if (admission.moved)
    return restart("the first fixes were far from those that followed, and so was the datum");
  for (const auto& [decided, reason] : admission.decided) {
    reason == Reason::kAccepted ? weigh(decided) : refuse(decided, reason);
  }
}

void LocalizationNode::weigh(const GnssMessage& message) {
  if (antenna_appeared(message)) return restart("tf has placed an antenna that was taken to be elsewhere");
  if (waits_for_frame(message)) return unplaced_.push_back(message);
  const CheckedMeasurement checked =
      to_measurement(message, *datum_.map(), parameters_.gnss,
                     [this](const std::string& frame) { return antenna_in_base(frame); });
  if (checked.reason == Reason::kInvalidPosition) {
    const std::optional<Geodetic> place = place_of(message, parameters_.gnss);
    return refuse(message, checked.reason, place ? datum_.distance_to(*place) : "");
  }
  if (checked.reason != Reason::kAccepted) return refuse(message, checked.reason);
  for (const std::string& frame : frames_of(message)) {
    const bool assumed = !tf_.antennas().in_base(frame) && assumed_.size() < kMostAssumed;
    if (assumed) assumed_.emplace(frame, parameters_.gnss.antenna_otherwise());
  }
  outputs_.publish_fixes(checked.measurement, message);
  localizer_.add(checked.measurement);
}

void LocalizationNode::weigh_waiting() {
  catch_up();
  for (const GnssMessage& message : std::exchange(unplaced_, {})) weigh(message);
  publish_reports();
  publish_poses();
}

bool LocalizationNode::waits_for_frame(const GnssMessage& message) {
  const std::vector<std::string> frames = frames_of(message);
  return std::any_of(frames.begin(), frames.end(), [this](const std::string& frame) {
    return !tf_.antennas().in_base(frame) && tf_.antennas().may_come(frame) &&
           patience_.lasts(without_slash(frame), odometry_stamp().toSec(), ros::WallTime::now().toSec());
  });
}

bool LocalizationNode::antenna_appeared(const GnssMessage& message) {
  const std::vector<std::string> frames = frames_of(message);
  return std::any_of(frames.begin(), frames.end(), [this](const std::string& frame) {
    const auto assumed = assumed_.find(frame);
    const std::optional<Eigen::Vector2d> antenna = tf_.antennas().in_base(frame);
    if (assumed == assumed_.end() || !antenna) return false;
    const Eigen::Vector2d before = assumed->second;
    assumed_.erase(assumed);
    return (*antenna - before).norm() > kSameAntenna;
  });
}

std::optional<Eigen::Vector2d> LocalizationNode::antenna_in_base(const std::string& frame) {
  const std::optional<Eigen::Vector2d> antenna = tf_.antennas().in_base(frame);
  if (diagnostics_.set_antenna_frame(frame, antenna || !parameters_.gnss.antenna.empty())) {
    ROS_WARN("no transform from %s to %s%s", parameters_.frames.base_link_frame.c_str(),
             tf_.antennas().described(frame).c_str(), parameters_.gnss.otherwise_at().c_str());
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

void LocalizationNode::publish(FixReport report, const Innovation& innovation, const std::string& detail) {
  const auto* const name = std::find(kGnssKinds.begin(), kGnssKinds.end(), report.kind);
  const auto kind = static_cast<std::size_t>(name - kGnssKinds.begin());
  report = concluded(report, innovation, odometry_stamp().toSec());
  gnss_.of(kind).count(innovation.reason, detail);
  diagnostics_.add(report, kind);
  if (const std::string why = gnss_.of(kind).complaint(); !why.empty()) ROS_WARN("%s", why.c_str());
  outputs_.publish(report);
}

}  // namespace multipath_localization
