#include "ros/inputs/odometry_reader.hpp"

#include <cmath>
#include <utility>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kLeastSideways = 1e-9;  ///< beyond rounding [m]
constexpr double kOfHalfTurn = 1.1;      ///< what may still come of the yaw at an end of the interval

bool finite(const nav_msgs::Odometry& message) {
  const auto& position = message.pose.pose.position;
  const auto& orientation = message.pose.pose.orientation;
  const auto& twist = message.twist.twist;
  for (const double value : {position.x, position.y, position.z, orientation.x, orientation.y, orientation.z,
                             orientation.w, twist.linear.x, twist.linear.y, twist.angular.z}) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

bool at_rest(const geometry_msgs::Twist& twist) {
  return twist.linear.x == 0.0 && twist.linear.y == 0.0 && twist.angular.z == 0.0;
}

/// Velocity and yaw rate of the arc that leads from the origin to `there` in `duration`. Drivers integrate
/// by the yaw at either end of an interval as well, which leads off an arc by half the turn: that much is no
/// motion sideways.
OdometryIncrement arc_to(const Pose2& there, double duration) {
  const double half_turn = 0.5 * there.yaw;
  const Eigen::Vector2d chord = rotation(-half_turn) * there.position();
  const bool sideways = std::abs(chord.y()) > kLeastSideways + std::abs(chord.x() * half_turn) * kOfHalfTurn;
  const double chord_per_arc = std::abs(half_turn) < 1e-6 ? 1.0 : std::sin(half_turn) / half_turn;
  OdometryIncrement increment;
  increment.duration = duration;
  increment.speed = chord.x() / chord_per_arc / duration;
  increment.yaw_rate = there.yaw / duration;
  if (sideways) increment.lateral_speed = chord.y() / chord_per_arc / duration;
  return increment;
}

}  // namespace

void OdometryParameters::fields(ParameterVisitor& field) {
  field("lateral", lateral,
        "read motion sideways, twist.linear.y; false for a base that cannot, of which it is noise");
  field("max_speed", max_speed, {0.1, 1e3}, "m/s", "odometry that claims more is refused");
  field("max_yaw_rate", max_yaw_rate, {0.1, 1e3}, "rad/s", "odometry that claims more is refused");
  field("max_gap", max_gap, {0.1, 600.0}, "s", "longer gaps in odometry are not bridged but start afresh");
  field("time_jump_threshold", time_jump_threshold, {0.0, 600.0}, "s",
        "a clock or odometry that goes back by more starts afresh");
}

OdometryReader::OdometryReader(const OdometryParameters& parameters, std::string map_frame)
    : parameters_(parameters), map_frame_(std::move(map_frame)) {}

void OdometryReader::clear() {
  last_pose_.reset();
  last_.reset();
  suspect_.reset();
  agreement_.clear();
}

CheckedOdometry OdometryReader::read(const nav_msgs::Odometry& message) {
  CheckedOdometry checked;
  checked.reason = check_content(message);
  if (checked.reason != Reason::kAccepted) return checked;
  const double stamp = message.header.stamp.toSec();
  checked.reason = check_time(stamp, checked.restarted);
  if (checked.reason != Reason::kAccepted) return checked;
  if (checked.restarted) clear();
  const Seen now = seen(message);
  checked.base_in_odom = now.base_in_odom;
  if (tells_no_turn(message, now)) {
    checked.reason = Reason::kInvalidOrientation;
    return checked;
  }
  checked.increment = motion(message, now);
  last_pose_ = now;
  if (ground_speed(checked.increment) > parameters_.max_speed ||
      std::abs(checked.increment.yaw_rate) > parameters_.max_yaw_rate) {
    checked.reason = Reason::kTooFast;
    return checked;
  }
  last_ = now;
  return checked;
}

OdometryReader::Seen OdometryReader::seen(const nav_msgs::Odometry& message) const {
  const geometry_msgs::Twist& twist = message.twist.twist;
  const double lateral_speed = parameters_.lateral ? twist.linear.y : 0.0;
  return {{message.header.stamp.toSec(), twist.linear.x, twist.angular.z, lateral_speed},
          *to_pose2(message.pose.pose),
          has_orientation(message.pose.pose)};
}

bool OdometryReader::tells_no_turn(const nav_msgs::Odometry& message, const Seen& now) const {
  if (now.oriented || !at_rest(message.twist.twist) || !last_pose_) return false;
  return now.base_in_odom.position() != last_pose_->base_in_odom.position();
}

Reason OdometryReader::check_content(const nav_msgs::Odometry& message) const {
  if (message.header.stamp.isZero()) return Reason::kZeroStamp;
  if (message.header.stamp.toSec() > kLatestStamp) return Reason::kFutureStamp;
  const std::string frame = without_slash(message.header.frame_id);
  if (!is_short(frame)) return Reason::kInvalidFrame;
  if (!map_frame_.empty() && frame == map_frame_) return Reason::kInvalidFrame;
  if (!finite(message)) return Reason::kNotFinite;
  if (!to_position(message.pose.pose)) return Reason::kInvalidPosition;
  if (!to_pose2(message.pose.pose)) return Reason::kInvalidOrientation;
  return Reason::kAccepted;
}

Reason OdometryReader::check_time(double stamp, bool& restarted) {
  if (!last_) return Reason::kAccepted;
  const double step = stamp - last_->stamp();
  if (step > 0.0 && step <= parameters_.max_gap) {
    suspect_.reset();
    return Reason::kAccepted;
  }
  const bool jumped = step > parameters_.max_gap || step < -parameters_.time_jump_threshold;
  restarted = jumped && suspect_ && stamp > *suspect_ && stamp - *suspect_ <= parameters_.max_gap;
  if (restarted) return Reason::kAccepted;
  if (jumped) suspect_ = stamp;
  return step > 0.0 ? Reason::kFutureStamp : Reason::kOldStamp;
}

/// By a twist, the latest: base drivers divide ticks by the time since the message before, or average that
/// over several. A mean with the twist before would lag by half an interval more.
OdometryIncrement OdometryReader::motion(const nav_msgs::Odometry& message, const Seen& now) {
  const double duration = last_ ? now.stamp() - last_->stamp() : kFirstInterval;
  OdometryIncrement increment = motion_of(now.twist, duration);
  if (last_pose_ && last_pose_->oriented && now.oriented && now.stamp() > last_pose_->stamp()) {
    const double step = now.stamp() - last_pose_->stamp();
    OdometryIncrement by_pose = arc_to(inverse(last_pose_->base_in_odom) * now.base_in_odom, step);
    if (!parameters_.lateral) by_pose.lateral_speed = 0.0;
    if (at_rest(message.twist.twist) || agreement_.agrees(by_pose, motion_of(now.twist, step)))
      increment = by_pose;
  }
  increment.stamp = now.stamp();
  increment.duration = duration;
  return increment;
}

}  // namespace multipath_localization
