#include "nodes/localization_node.hpp"

#include <ros/console.h>

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
      datum_(parameters_.datum, parameters_.datum_averaging),
      odometry_reader_(parameters_.odometry, parameters_.frames.map_frame),
      tf_(node, parameters_.frames),
      map_to_odom_(parameters_.frames, parameters_.outputs),
      outputs_(node, private_node, parameters_),
      fix_input_("fix", node.subscribe("gps/fix", 500, &LocalizationNode::on_fix, this, at_once())),
      odometry_input_("odom", node.subscribe("odom", 1000, &LocalizationNode::on_odometry, this, at_once())),
      diagnostics_(fix_input_, odometry_input_, localizer_, tf_, parameters_) {
  initial_pose_ = node.subscribe("initialpose", 5, &LocalizationNode::on_pose, this);
  set_pose_ = node.subscribe("set_pose", 5, &LocalizationNode::on_pose, this);
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
           fix_input_.described().c_str(), odometry_input_.described().c_str(),
           parameters_.frames.map_frame.c_str(), parameters_.frames.odom_frame.c_str(),
           parameters_.frames.base_link_frame.c_str());
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
  unanswered_.push_back(*odometry_);
  if (parameters_.outputs.publish_odom_tf && tf_.broadcaster_of_base().empty()) {
    map_to_odom_.send_odometry(checked.base_in_odom, message->header.stamp);
  }
  publish_poses();
  publish_reports();
  if (early_fix_) use(*std::exchange(early_fix_, std::nullopt));
  diagnostics_.add_update_time((ros::WallTime::now() - begin).toSec());
}

void LocalizationNode::on_fix(const sensor_msgs::NavSatFix::ConstPtr& message) {
  if (!enabled_) return;
  watch_clock();
  fix_input_.arrived();
  fixes_.open(*message);
  if (odometry_) return use(*message);
  if (early_fix_) report(early_fix_->header.stamp.toSec(), refused(Reason::kNotStarted));
  early_fix_ = *message;
}

void LocalizationNode::use(const sensor_msgs::NavSatFix& message) {
  const Reason reason = hand_over(message);
  if (reason != Reason::kAccepted) report(message.header.stamp.toSec(), refused(reason));
  publish_reports();
  publish_poses();
}

Reason LocalizationNode::hand_over(const sensor_msgs::NavSatFix& message) {
  const Reason defect = check(message, parameters_.fix);
  if (defect != Reason::kAccepted) return defect;
  const std::optional<Eigen::Vector2d> antenna = antenna_in_base(message.header.frame_id);
  if (!antenna) return Reason::kInvalidFrame;
  datum_.add(message);
  if (!datum_.map()) return Reason::kNotStarted;
  const CheckedFix checked = to_fix(message, *datum_.map(), parameters_.fix, *antenna);
  if (checked.reason != Reason::kAccepted) return checked.reason;
  outputs_.publish_fix(checked.fix, message.header);
  localizer_.add(checked.fix);
  return Reason::kAccepted;
}

std::optional<Eigen::Vector2d> LocalizationNode::antenna_in_base(const std::string& frame) {
  std::optional<Eigen::Vector2d> antenna = tf_.origin_in_base(frame);
  diagnostics_.set_unknown_antenna_frame(antenna ? "" : frame);
  if (antenna || parameters_.require_antenna_transform) return antenna;
  ROS_WARN_ONCE("no transform from %s to %s: the antenna is taken to be at the base",
                parameters_.frames.base_link_frame.c_str(), frame.c_str());
  return Eigen::Vector2d::Zero();
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
  map_to_odom_.send(odom_in_map, odometry_stamp(), ros::Time::now());
}

void LocalizationNode::publish_reports() {
  for (const MeasurementReport& done : localizer_.take_reports()) {
    report(done.stamp, done.innovation);
    outputs_.publish_bias(localizer_.estimate(), odometry_stamp());
  }
}

void LocalizationNode::report(double stamp, const Innovation& innovation) {
  const std::optional<FixLedger::Entry> entry = fixes_.close(stamp);
  if (!entry) return;
  const FixReport message = to_report(innovation, entry->fix, odometry_stamp().toSec(), entry->sequence);
  fix_input_.count(innovation.reason);
  diagnostics_.add(message);
  outputs_.publish(message);
}

}  // namespace multipath_localization
