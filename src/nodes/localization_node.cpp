#include "nodes/localization_node.hpp"

#include <ros/console.h>

#include <algorithm>
#include <utility>

namespace multipath_localization {

namespace {

constexpr double kAnsweredLate = 0.5;      ///< [s]
constexpr double kTellEvery = 5.0;         ///< [s]
constexpr double kDiagnosticsEvery = 1.0;  ///< [s]

ros::TransportHints at_once() { return ros::TransportHints().tcpNoDelay(); }

}  // namespace

LocalizationNode::LocalizationNode(ros::NodeHandle node, ros::NodeHandle private_node,
                                   const LocalizationSettings& settings)
    : parameters_(settings.parameters),
      localizer_(settings.make_estimator(), parameters_.localizer),
      datum_(parameters_.datum.place(), parameters_.datum_averaging, parameters_.datum_file),
      map_services_(node, datum_, parameters_.frames.map_frame, [this] { forget("a datum was set"); }),
      odometry_reader_(parameters_.odometry, parameters_.frames.map_frame),
      tf_(node, parameters_.frames),
      map_to_odom_(parameters_.frames, parameters_.outputs),
      outputs_(node, private_node, parameters_),
      used_(settings.used_kinds()),
      gnss_(
          node, parameters_.gnss.pair_tolerance, used_, [this](const GnssMessage& m) { on_gnss(m); },
          [this](const sensor_msgs::NavSatFix& fix) { on_unpaired(fix); }),
      odometry_input_("odom", {node.subscribe("odom", 1000, &LocalizationNode::on_odometry, this, at_once())},
                      true),
      diagnostics_(gnss_, odometry_input_, localizer_, tf_, parameters_),
      reconfiguration_(private_node, [this](ParameterVisitor& field) { tune(field); }) {
  initial_pose_ = node.subscribe("initialpose", 5, &LocalizationNode::on_pose, this);
  pose_to_set_ = node.subscribe("set_pose", 5, &LocalizationNode::on_pose, this);
  set_pose_ = node.advertiseService("set_pose", &LocalizationNode::on_set_pose, this);
  global_localization_ = node.advertiseService("global_localization", &LocalizationNode::on_reset, this);
  reset_ = private_node.advertiseService("reset", &LocalizationNode::on_reset, this);
  toggle_ = private_node.advertiseService("toggle", &LocalizationNode::on_toggle, this);
  tf_timer_ =
      node.createTimer(ros::Duration(1.0 / parameters_.outputs.tf_rate), [this](const ros::TimerEvent&) {
        watch_clock();
        if (enabled_) map_to_odom_.keep_up(ros::Time::now(), parameters_.odometry.max_gap);
      });
  diagnostics_timer_ = node.createWallTimer(ros::WallDuration(kDiagnosticsEvery),
                                            [this](const ros::WallTimerEvent&) { diagnostics_.report(); });
  waiting_timer_ = node.createWallTimer(ros::WallDuration(kTellEvery),
                                        [this](const ros::WallTimerEvent&) { tell_what_is_missing(); });
  outputs_.publish_changed_state(localizer_, ros::Time());
  ROS_INFO("%s with seed %d; %s, %s; %s -> %s -> %s", parameters_.estimator.c_str(), parameters_.seed,
           gnss_.described().c_str(), odometry_input_.described().c_str(),
           parameters_.frames.map_frame.c_str(), parameters_.frames.odom_frame.c_str(),
           parameters_.frames.base_link_frame.c_str());
}

void LocalizationNode::tune(ParameterVisitor& field) {
  map_to_odom_.tune(field);
  VisitedGroup localizer{[this](ParameterVisitor& inner) { localizer_.tune(inner); }};
  VisitedGroup estimator{[this](ParameterVisitor& inner) { localizer_.tune_estimator(inner); }};
  field.group("localizer", localizer, "");
  field.group(parameters_.estimator, estimator, "");
}

void LocalizationNode::on_odometry(const nav_msgs::Odometry::ConstPtr& message) {
  if (!enabled_) return;
  watch_clock();
  odometry_input_.arrived();
  const CheckedOdometry checked = odometry_reader_.read(*message);
  odometry_input_.count(checked.reason);
  if (checked.restarted) restart_time("the stamps of odometry have jumped");
  if (checked.reason != Reason::kAccepted) {
    ROS_WARN_THROTTLE(kTellEvery, "odometry refused: %s", std::string(to_string(checked.reason)).c_str());
    return;
  }
  const ros::WallTime begin = ros::WallTime::now();
  localizer_.add(checked.increment);
  odometry_ = {with_motion(*message, checked.increment), checked.base_in_odom};
  if (!std::exchange(started_, true)) resume();
  unanswered_.push_back(*odometry_);
  if (parameters_.outputs.publish_odom_tf && tf_.broadcaster_of_base().empty()) {
    map_to_odom_.send_odometry(checked.base_in_odom, message->header.stamp);
  }
  publish_poses();
  publish_reports();
  for (const auto& [kind, early] : std::exchange(early_, {})) use(early);
  diagnostics_.add_update_time((ros::WallTime::now() - begin).toSec());
}

void LocalizationNode::on_gnss(const GnssMessage& message) {
  if (!enabled_) return;
  watch_clock();
  reports_.open(to_report(message));
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
    ROS_WARN("no transform from %s to %s%s", parameters_.frames.base_link_frame.c_str(), frame.c_str(),
             parameters_.gnss.require_antenna_transform ? "" : ": a lone antenna is taken to be at the base");
  }
  return antenna;
}

void LocalizationNode::publish_poses() {
  if (unanswered_.empty()) return;
  const PoseEstimate estimate = localizer_.estimate();
  if (estimate.valid && !finite(estimate)) return restart("the estimate was not finite");
  if (!estimate.valid || !datum_.map()) {
    const double now = odometry_stamp().toSec();
    while (unanswered_.front().message.header.stamp.toSec() < now - kAnsweredLate) unanswered_.pop_front();
    return outputs_.publish_changed_state(localizer_, odometry_stamp());
  }
  const Pose2 odom_in_map = estimate.pose * inverse(odometry_->base_in_odom);
  for (const ReadOdometry& odometry : std::exchange(unanswered_, {})) {
    PoseEstimate then = estimate;
    then.pose = odom_in_map * odometry.base_in_odom;
    outputs_.publish(localizer_, then, odometry.message, *datum_.map());
    diagnostics_.add_pose();
  }
  if (!estimate.aligned) map_to_odom_.jump();
  save_pose(estimate);
  map_to_odom_.send(odom_in_map, odometry_->base_in_odom, odometry_stamp(), ros::Time::now());
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
