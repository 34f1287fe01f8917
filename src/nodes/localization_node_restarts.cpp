#include <ros/console.h>

#include "nodes/localization_node.hpp"

/// The part of the node that starts it afresh: by request, by a jump in time, by a breakdown.
namespace multipath_localization {

namespace {

constexpr double kLongSilence = 5.0;  ///< [s]

}  // namespace

bool LocalizationNode::set_pose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const std::string frame = without_slash(message.header.frame_id);
  std::optional<PosePrior> prior = to_prior(message);
  if (!frame.empty() && frame != parameters_.frames.map_frame) {
    ROS_WARN("pose refused: it is given in %s, not in %s", frame.c_str(),
             parameters_.frames.map_frame.c_str());
  } else if (!prior) {
    ROS_WARN("pose refused: pose or covariance cannot be used");
  } else if (!datum_.map()) {
    ROS_WARN("pose refused: map has no datum yet; set the parameter datum or wait for the first fix");
  } else {
    prior->stamp = odometry_stamp().toSec();
    restart("a pose was set", prior);
    return true;
  }
  return false;
}

bool LocalizationNode::on_reset(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
  forget("asked to");
  return true;
}

bool LocalizationNode::on_toggle(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  if (request.data && !enabled_) forget("switched on");
  enabled_ = request.data;
  if (!enabled_) diagnostics_.note("switched off by ~toggle");
  response.success = true;
  response.message = enabled_ ? "on" : "off: nothing is read or published";
  return true;
}

void LocalizationNode::restart(const std::string& why, const std::optional<PosePrior>& prior) {
  ROS_WARN("starting afresh: %s", why.c_str());
  diagnostics_.note("started afresh: " + why);
  publish_reports();
  localizer_.start(prior);
  map_to_odom_.jump();
  early_.clear();
  unanswered_.clear();
  gnss_.clear();
  while (const auto left = reports_.close_oldest()) publish(*left, refused(Reason::kNotStarted));
  outputs_.clear();
  outputs_.publish_changed_state(localizer_, odometry_stamp());
}

void LocalizationNode::restart_time(const std::string& why) {
  odometry_.reset();
  restart(why);
  map_to_odom_.clear();
  tf_.clear();
}

void LocalizationNode::forget(const std::string& why) {
  odometry_reader_.clear();
  restart_time(why);
}

void LocalizationNode::watch_clock() {
  const ros::Time now = ros::Time::now();
  if (now.toSec() < latest_clock_.toSec() - parameters_.odometry.time_jump_threshold) {
    forget("the clock has gone back");
  }
  latest_clock_ = now;
}

void LocalizationNode::tell_what_is_missing() {
  if (!enabled_) return;
  std::string missing;
  if (odometry_input_.silence() >= kLongSilence) missing = odometry_input_.described();
  if (gnss_.silence() >= kLongSilence) missing += (missing.empty() ? "" : ", ") + gnss_.described();
  if (!missing.empty()) ROS_WARN("waiting for: %s", missing.c_str());
}

}  // namespace multipath_localization
