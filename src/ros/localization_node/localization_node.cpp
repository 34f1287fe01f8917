#include "ros/localization_node/localization_node.hpp"

#include <ros/callback_queue.h>
#include <ros/console.h>

#include <algorithm>
#include <utility>

namespace multipath_localization {

namespace {

constexpr std::uint32_t kQueue = 5000;     ///< of odometry, seconds of it at 1 kHz
constexpr double kLongestHeld = 0.1;       ///< odometry that is summed up [s]
constexpr double kAnsweredLate = 0.5;      ///< [s]
constexpr double kTellEvery = 5.0;         ///< [s]
constexpr double kDiagnosticsEvery = 1.0;  ///< [s]
constexpr double kWaitForMessages = 0.1;   ///< [s]

ros::TransportHints at_once() { return ros::TransportHints().tcpNoDelay(); }

}  // namespace

LocalizationNode::LocalizationNode(ros::NodeHandle node, ros::NodeHandle private_node,
                                   const LocalizationSettings& settings)
    : parameters_(settings.parameters),
      localizer_(settings.make_estimator(), parameters_.localizer),
      datum_(parameters_.datum.place(),
             DatumSearch(parameters_.gnss, parameters_.odometry.max_speed, parameters_.datum_averaging),
             parameters_.datum_file),
      map_services_(node, datum_, parameters_.frames.map_frame, [this] { forget("a datum was set"); }),
      odometry_reader_(parameters_.odometry, parameters_.frames.map_frame),
      tf_(node, parameters_.frames),
      map_to_odom_(parameters_.frames, parameters_.outputs),
      outputs_(node, private_node, parameters_),
      used_(settings.used_kinds()),
      gnss_(
          node, parameters_.gnss, used_, [this](const GnssMessage& m) { on_gnss(m); },
          [this](const sensor_msgs::NavSatFix& fix) { on_unpaired(fix); }),
      odometry_input_(
          "odom", {node.subscribe("odom", kQueue, &LocalizationNode::on_odometry, this, at_once())}, true),
      gyro_input_(
          node, [this](const std::string& frame) { return tf_.antennas().rotation_in_base(frame); },
          [this](const YawRate& yaw_rate) { on_yaw_rate(yaw_rate); }),
      diagnostics_({gnss_, odometry_input_, gyro_input_}, localizer_, tf_, backlog_, parameters_),
      reconfiguration_(private_node, [this](ParameterVisitor& field) { tune(field); }),
      backlog_(parameters_.max_lag) {
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
  diagnostics_timer_ =
      node.createWallTimer(ros::WallDuration(kDiagnosticsEvery), [this](const ros::WallTimerEvent&) {
        diagnostics_.report();
        gnss_.tell_new();
        gyro_input_.tell(localizer_.gyro());
      });
  waiting_timer_ = node.createWallTimer(ros::WallDuration(kTellEvery),
                                        [this](const ros::WallTimerEvent&) { tell_what_is_missing(); });
  outputs_.publish_changed_state(localizer_, ros::Time());
  ROS_INFO("%s with seed %d; %s, %s; %s -> %s -> %s", parameters_.estimator.c_str(), parameters_.seed,
           gnss_.described().c_str(), odometry_input_.described().c_str(),
           parameters_.frames.map_frame.c_str(), parameters_.frames.odom_frame.c_str(),
           parameters_.frames.base_link_frame.c_str());
}

void LocalizationNode::spin() {
  while (ros::ok()) {
    backlog_.begin_turn();
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kWaitForMessages));
    if (held_.duration() > 0.0) answer_odometry();
    if (!unplaced_.empty()) weigh_waiting();
  }
  tell_sums();
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
    if (const std::string why = odometry_input_.complaint(); !why.empty()) ROS_WARN("%s", why.c_str());
    return;
  }
  const ros::WallTime begin = ros::WallTime::now();
  if (const auto before = held_.add(checked.increment)) localizer_.add(*before);
  odometry_ = {with_motion(*message, checked.increment), checked.base_in_odom};
  if (!std::exchange(started_, true)) resume();
  unanswered_.push_back(*odometry_);
  if (parameters_.outputs.publish_odom_tf && tf_.broadcaster_of_base().empty()) {
    map_to_odom_.send_odometry(checked.base_in_odom, message->header.stamp);
  }
  if (backlog_.take(begin) && held_.duration() < kLongestHeld) return backlog_.count_merged();
  answer_odometry();
  for (const auto& [kind, early] : std::exchange(early_, {})) use(early);
  if (!unplaced_.empty()) weigh_waiting();
  diagnostics_.add_update_time((ros::WallTime::now() - begin).toSec());
}

void LocalizationNode::catch_up() {
  if (const auto increment = held_.take()) localizer_.add(*increment);
}

void LocalizationNode::answer_odometry() {
  catch_up();
  publish_poses();
  publish_reports();
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

}  // namespace multipath_localization
