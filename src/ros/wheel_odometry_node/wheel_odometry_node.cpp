#include "ros/wheel_odometry_node/wheel_odometry_node.hpp"

#include "ros/messages/conversions.hpp"
#include "ros/wheel_odometry_node/odometry_message.hpp"

namespace multipath_localization {

namespace {

constexpr std::uint32_t kQueue = 1000;
constexpr double kReportEvery = 1.0;  // [s]
constexpr double kTellEvery = 5.0;    // [s]
constexpr double kLongSilence = 5.0;  // [s]
constexpr const char* kDegrees = "is the steering angle in degrees, the speed in km/h?";

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + shown(name);
  return text;
}

}  // namespace

WheelOdometryNode::WheelOdometryNode(ros::NodeHandle node, const WheelOdometryParameters& parameters)
    : parameters_(parameters),
      joints_(parameters.joints()),
      odometer_(parameters.geometry, parameters.limits),
      odometry_(node.advertise<nav_msgs::Odometry>("odom", kQueue)),
      monitor_("wheels", {subscribed(node)}, true) {
  parameters_.require_all();
  updater_.setHardwareID("none");
  updater_.add("wheels", this, &WheelOdometryNode::diagnose);
  report_timer_ = node.createWallTimer(ros::WallDuration(kReportEvery),
                                       [this](const ros::WallTimerEvent&) { updater_.force_update(); });
  wrong_timer_ = node.createWallTimer(ros::WallDuration(kTellEvery),
                                      [this](const ros::WallTimerEvent&) { tell_what_is_wrong(); });
  ROS_INFO("%s; odometry of %s in %s", monitor_.described().c_str(), parameters_.base_link_frame.c_str(),
           parameters_.odom_frame.c_str());
}

ros::Subscriber WheelOdometryNode::subscribed(ros::NodeHandle& node) {
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  if (parameters_.source == WheelSource::kJoints)
    return node.subscribe("joint_states", kQueue, &WheelOdometryNode::on_joints, this, hints);
  return node.subscribe("ackermann", kQueue, &WheelOdometryNode::on_drive, this, hints);
}

void WheelOdometryNode::on_joints(const sensor_msgs::JointState::ConstPtr& message) {
  const JointsRead read = read_joints(*message, joints_);
  if (!read.names_any) {
    other_joints_ = listed(message->name);
    return take(message->header.stamp, {Reason::kUnused, std::nullopt}, "");
  }
  const std::string detail = read.missing.empty() ? "" : "nothing of " + listed(read.missing);
  take(message->header.stamp, odometer_.take(message->header.stamp.toSec(), read.readings), detail);
}

void WheelOdometryNode::on_drive(const AckermannDriveStamped::ConstPtr& message) {
  const WheelMotion told =
      odometer_.take(message->header.stamp.toSec(), DriveReading{message->speed, message->steering_angle});
  take(message->header.stamp, told, told.reason == Reason::kTooFast ? kDegrees : "");
}

void WheelOdometryNode::take(const ros::Time& stamp, const WheelMotion& told, const std::string& detail) {
  monitor_.arrived();
  monitor_.count(told.reason, detail);
  if (const std::string why = monitor_.complaint(); !why.empty()) ROS_WARN("%s", why.c_str());
  if (!told.motion) return;
  base_in_odom_ = base_in_odom_ * displacement(*told.motion);
  odometry_.publish(to_odometry(stamp, *told.motion, base_in_odom_, parameters_));
}

std::string WheelOdometryNode::strangers() const {
  const ReasonTally& tally = monitor_.tally();
  if (!monitor_.seen() || tally.of(Reason::kUnused) != tally.total()) return "";
  return "no message names a wheel (" + listed(joints_.left) + ", " + listed(joints_.right) +
         "); the last one names " + other_joints_;
}

void WheelOdometryNode::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  summarise(status, monitor_);
  const std::string wrong = strangers();
  if (!wrong.empty()) status.summary(diagnostic_msgs::DiagnosticStatus::ERROR, wrong);
}

void WheelOdometryNode::tell_what_is_wrong() {
  if (monitor_.silent(kLongSilence)) ROS_WARN("waiting for: %s", monitor_.described().c_str());
  if (const std::string wrong = strangers(); !wrong.empty()) ROS_WARN("%s", wrong.c_str());
}

}  // namespace multipath_localization
