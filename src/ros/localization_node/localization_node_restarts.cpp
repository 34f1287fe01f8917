#include <ros/console.h>

#include <cmath>
#include <iostream>

#include "ros/localization_node/localization_node.hpp"
#include "ros/localization_node/saved_pose.hpp"

/// The part of the node that starts it afresh: by request, by a jump in time, by a breakdown.
namespace multipath_localization {

namespace {

constexpr double kLongSilence = 5.0;  ///< [s]
constexpr double kSaveEvery = 1.0;    ///< [s]
constexpr double kTellSaving = 60.0;  ///< [s]
constexpr double kSameDatum = 0.01;   ///< two are one within this [m]

/// `message` has its motion in its twist.
OdometryState state_of(const nav_msgs::Odometry& message, const Pose2& base_in_odom) {
  const geometry_msgs::Twist& twist = message.twist.twist;
  return {message.header.stamp.toSec(), base_in_odom, std::hypot(twist.linear.x, twist.linear.y),
          twist.angular.z};
}

void save(const std::string& file, const SavedPose& pose) {
  try {
    write_saved_pose(file, pose);
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(kTellSaving, "the pose is not saved: %s", error.what());
  }
}

}  // namespace

bool LocalizationNode::set_pose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const std::string frame = without_slash(message.header.frame_id);
  std::optional<PosePrior> prior = to_prior(message);
  if (!frame.empty() && frame != parameters_.frames.map_frame) {
    ROS_WARN("pose refused: it is given in %s, not in %s", shown(frame).c_str(),
             parameters_.frames.map_frame.c_str());
  } else if (!prior) {
    ROS_WARN("pose refused: %s", defect_of(message).c_str());
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
  held_.take();
  map_to_odom_.jump();
  early_.clear();
  unplaced_.clear();
  datum_.drop_waiting();
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
}

void LocalizationNode::forget(const std::string& why) {
  odometry_reader_.clear();
  restart_time(why);
}

void LocalizationNode::resume() {
  if (parameters_.pose_file.empty()) return;
  try {
    const std::optional<SavedPose> saved = read_saved_pose(parameters_.pose_file);
    if (!saved) return;
    const OdometryState now = state_of(odometry_->message, odometry_->base_in_odom);
    const auto answer = resumed(*saved, now, parameters_.pose_file_max_age);
    if (const auto* why = std::get_if<std::string>(&answer)) throw ParameterError(*why);
    if (!datum_.map()) datum_.set(saved->datum);
    if (datum_.map()->to_map(saved->datum).norm() > kSameDatum)
      throw ParameterError("its map has another datum");
    map_services_.tell_origin(odometry_stamp());
    const auto& prior = std::get<PosePrior>(answer);
    restart(prior.confirmed ? "at the pose that the last run saved"
                            : "near the pose that the last run saved, to be confirmed",
            prior);
  } catch (const std::exception& error) {
    ROS_WARN("pose saved in %s does not count: %s", parameters_.pose_file.c_str(), error.what());
    diagnostics_.note("the saved pose does not count: " + std::string(error.what()));
  }
}

void LocalizationNode::save_pose(const PoseEstimate& estimate) {
  const double stamp = odometry_stamp().toSec();
  if (parameters_.pose_file.empty() || !datum_.settled() || std::abs(stamp - pose_saved_) < kSaveEvery)
    return;
  pose_saved_ = stamp;
  const SavedPose pose{datum_.map()->datum(), estimate.pose, covariance_overall(estimate),
                       state_of(odometry_->message, odometry_->base_in_odom), estimate.aligned};
  pose_writer_.write([file = parameters_.pose_file, pose] { save(file, pose); });
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
  if (odometry_input_.silent(kLongSilence)) missing = odometry_input_.described();
  if (gnss_.silent(kLongSilence)) missing += (missing.empty() ? "" : ", ") + gnss_.described();
  if (!missing.empty()) ROS_WARN("waiting for: %s", missing.c_str());
}

void LocalizationNode::tell_sums() const {
  std::vector<std::string> sums = gnss_.sums();
  sums.push_back(odometry_input_.sum());
  sums.push_back(gyro_input_.monitor().sum());
  for (const std::string& sum : sums) {
    if (!sum.empty()) std::cerr << ros::this_node::getName() << ": " << sum << "\n";
  }
}

}  // namespace multipath_localization
