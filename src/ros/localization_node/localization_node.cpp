#include "ros/localization_node/localization_node.hpp"

#include <ros/callback_queue.h>
#include <ros/console.h>

namespace multipath_localization {

namespace {

constexpr double kLongestHeld = 0.1;      ///< odometry that is summed up [s]
constexpr double kWaitForMessages = 0.1;  ///< [s]

/// Whether the pose knows no slopes: one that has roll and pitch moves by the way over the map already.
bool is_planar(const nav_msgs::Odometry& odometry) {
  return odometry.pose.pose.orientation.x == 0.0 && odometry.pose.pose.orientation.y == 0.0;
}

}  // namespace

LocalizationNode::LocalizationNode(ros::NodeHandle node, ros::NodeHandle private_node,
                                   const LocalizationSettings& settings)
    : parameters_(settings.parameters),
      localizer_(settings.make_estimator(), parameters_.localizer),
      datum_(parameters_.datum.place(),
             DatumSearch(parameters_.gnss, parameters_.odometry.max_speed, parameters_.datum_averaging),
             parameters_.datum_file),
      map_services_(node, datum_, parameters_.frames.map_frame, [this] { forget("a datum was set"); }),
      tf_(node, parameters_.frames),
      outputs_(node, private_node, parameters_),
      answers_(parameters_, outputs_),
      requests_(node, private_node, parameters_.frames.map_frame, datum_,
                {[this](PosePrior prior) {
                   prior.stamp = answers_.odometry().stamp().toSec();
                   restart("a pose was set", prior);
                 },
                 [this](const std::string& why) { forget(why); },
                 [this] { diagnostics_.note("switched off by ~toggle"); }}),
      odometry_(node, parameters_.odometry, parameters_.frames.map_frame,
                [this](const nav_msgs::Odometry& message) { on_odometry(message); }),
      tilt_(node, parameters_.tilt,
            [this](const std::string& frame) { return tf_.antennas().rotation_in_base(frame); }),
      gnss_(node, settings.used_kinds(),
            {parameters_, localizer_, datum_, map_services_, tf_, tilt_, outputs_, diagnostics_, backlog_,
             answers_.odometry(), requests_.enabled()},
            {[this] { watch_clock(); }, [this] { catch_up(); }, [this] { answer(); },
             [this](const std::string& why) { restart(why); }}),
      gyro_(
          node, [this](const std::string& frame) { return tf_.antennas().rotation_in_base(frame); },
          [this](const YawRate& yaw_rate) {
            if (requests_.enabled()) localizer_.add(over_map(tilt_.at(yaw_rate.stamp), yaw_rate));
          }),
      diagnostics_({gnss_.inputs(), odometry_.monitor(), gyro_, tilt_}, localizer_, tf_, backlog_,
                   parameters_),
      reports_(node, {diagnostics_, gnss_.inputs(), odometry_.monitor(), gyro_, tilt_, localizer_,
                      requests_.enabled()}),
      reconfiguration_(private_node, [this](ParameterVisitor& field) { tune(field); }),
      backlog_(parameters_.max_lag) {
  tf_timer_ =
      node.createTimer(ros::Duration(1.0 / parameters_.outputs.tf_rate), [this](const ros::TimerEvent&) {
        watch_clock();
        if (requests_.enabled())
          answers_.map_to_odom().keep_up(ros::Time::now(), parameters_.odometry.max_gap);
      });
  outputs_.publish_changed_state(localizer_, ros::Time());
  ROS_INFO("%s with seed %d; %s, %s; %s -> %s -> %s", parameters_.estimator.c_str(), parameters_.seed,
           gnss_.inputs().described().c_str(), odometry_.monitor().described().c_str(),
           parameters_.frames.map_frame.c_str(), parameters_.frames.odom_frame.c_str(),
           parameters_.frames.base_link_frame.c_str());
}

void LocalizationNode::spin() {
  while (ros::ok()) {
    backlog_.begin_turn();
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kWaitForMessages));
    if (odometry_.held().duration() > 0.0) answer_odometry();
    gnss_.weigh_waiting();
  }
  reports_.tell_sums();
}

void LocalizationNode::tune(ParameterVisitor& field) {
  answers_.map_to_odom().tune(field);
  VisitedGroup localizer{[this](ParameterVisitor& inner) { localizer_.tune(inner); }};
  VisitedGroup estimator{[this](ParameterVisitor& inner) { localizer_.tune_estimator(inner); }};
  field.group("localizer", localizer, "");
  field.group(parameters_.estimator, estimator, "");
}

void LocalizationNode::on_odometry(const nav_msgs::Odometry& message) {
  if (!requests_.enabled()) return;
  watch_clock();
  const CheckedOdometry checked = odometry_.read(message);
  if (checked.restarted) restart_time("the stamps of odometry have jumped");
  if (checked.reason != Reason::kAccepted) return;
  const ros::WallTime begin = ros::WallTime::now();
  tilt_.drive(checked.increment);
  const Tilt tilt = tilt_.at(checked.increment.stamp);
  const OdometryIncrement driven = is_planar(message) ? over_map(tilt, checked.increment) : checked.increment;
  if (const auto before = odometry_.held().add(driven)) localizer_.add(*before);
  OdometryLog& log = answers_.odometry();
  if (log.note({with_motion(message, checked.increment), checked.base_in_odom, tilt})) resume();
  log.await_answer();
  if (parameters_.outputs.publish_odom_tf && tf_.broadcaster_of_base().empty()) {
    answers_.map_to_odom().send_odometry(checked.base_in_odom, tilt, message.header.stamp);
  }
  if (backlog_.take(begin) && odometry_.held().duration() < kLongestHeld) return backlog_.count_merged();
  answer_odometry();
  gnss_.use_early();
  gnss_.weigh_waiting();
  diagnostics_.add_update_time((ros::WallTime::now() - begin).toSec());
}

void LocalizationNode::catch_up() {
  if (const auto increment = odometry_.held().take()) localizer_.add(*increment);
}

void LocalizationNode::answer() {
  const std::optional<unsigned> poses = answers_.publish(localizer_, datum_);
  if (!poses) return restart("the estimate was not finite");
  diagnostics_.add_poses(*poses);
}

void LocalizationNode::answer_odometry() {
  catch_up();
  answer();
  gnss_.publish_done();
}

void LocalizationNode::restart(const std::string& why, const std::optional<PosePrior>& prior) {
  ROS_WARN("starting afresh: %s", why.c_str());
  diagnostics_.note("started afresh: " + why);
  gnss_.publish_done();
  localizer_.start(prior);
  odometry_.held().take();
  answers_.map_to_odom().jump();
  answers_.odometry().take_unanswered();
  gnss_.restart();
  outputs_.clear();
  outputs_.publish_changed_state(localizer_, answers_.odometry().stamp());
}

void LocalizationNode::restart_time(const std::string& why) {
  answers_.odometry().forget_last();
  restart(why);
  answers_.map_to_odom().clear();
}

void LocalizationNode::forget(const std::string& why) {
  odometry_.clear();
  restart_time(why);
}

void LocalizationNode::resume() {
  try {
    const auto saved = answers_.persistence().start(answers_.state(), datum_.map());
    if (!saved) return;
    if (!datum_.map()) datum_.set(saved->datum);
    map_services_.tell_origin(answers_.odometry().stamp());
    restart(saved->prior.confirmed ? "at the pose that the last run saved"
                                   : "near the pose that the last run saved, to be confirmed",
            saved->prior);
  } catch (const std::exception& error) {
    ROS_WARN("pose saved in %s does not count: %s", answers_.persistence().file().c_str(), error.what());
    diagnostics_.note("the saved pose does not count: " + std::string(error.what()));
  }
}

void LocalizationNode::watch_clock() {
  const ros::Time now = ros::Time::now();
  if (now.toSec() < latest_clock_.toSec() - parameters_.odometry.time_jump_threshold) {
    forget("the clock has gone back");
  }
  latest_clock_ = now;
}

}  // namespace multipath_localization
