#include "tools/doctor/twist_comparison.hpp"

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr double kWindow = 0.2;    // [s]
constexpr double kLongest = 2.0;   // [s]
constexpr double kMoving = 0.05;   // [m/s]
constexpr double kTurning = 0.05;  // [rad/s]

struct Sample {
  double stamp;
  Pose2 pose;
  geometry_msgs::Twist twist;
};

/// The window in base coordinates: the arc that the poses lead along, and the twist by the mean heading.
void close(const Pose2& from, const Pose2& to, const Eigen::Vector2d& twist_summed, TwistWindow& window) {
  const Pose2 moved = inverse(from) * to;
  const double half_turn = 0.5 * moved.yaw;
  const double chord_per_arc = std::abs(half_turn) < 1e-6 ? 1.0 : std::sin(half_turn) / half_turn;
  window.yaw = wrap_angle(from.yaw + half_turn);
  window.by_pose = rotation(-half_turn) * moved.position() / chord_per_arc;
  window.turn_by_pose = moved.yaw;
  window.by_twist = twist_summed;
  window.by_twist_in_odom = rotation(-window.yaw) * twist_summed;
}

/// The messages with a usable pose.
std::vector<Sample> samples_of(const Observations& seen) {
  std::vector<Sample> samples;
  for (const auto& arrived : seen.odometry) {
    const std::optional<Pose2> pose = to_pose2(arrived.message.pose.pose);
    if (pose) samples.push_back({arrived.message.header.stamp.toSec(), *pose, arrived.message.twist.twist});
  }
  return samples;
}

}  // namespace

bool TwistWindow::moves() const {
  return by_pose.norm() > kMoving * duration || by_twist.norm() > kMoving * duration ||
         std::abs(turn_by_pose) > kTurning * duration || std::abs(turn_by_twist) > kTurning * duration;
}

TwistComparison compare_twist(const Observations& seen) {
  TwistComparison all;
  all.messages = seen.odometry.size();
  for (const auto& arrived : seen.odometry) {
    if (!has_orientation(arrived.message.pose.pose)) ++all.without_orientation;
  }
  const std::vector<Sample> samples = samples_of(seen);
  TwistWindow window;
  Eigen::Vector2d summed(0.0, 0.0);
  std::size_t first = 0;
  bool empty = true;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double step = samples[i].stamp - samples[i - 1].stamp;
    const bool leaps = step < 0.0 || step > kLongest;
    if (!leaps) {
      const geometry_msgs::Twist& twist = samples[i].twist;
      summed += step * Eigen::Vector2d(twist.linear.x, twist.linear.y);
      window.turn_by_twist += step * twist.angular.z;
      window.duration += step;
      if (window.duration < kWindow) continue;
      close(samples[first].pose, samples[i].pose, summed, window);
      if (window.moves()) {
        all.moving.push_back(window);
        empty = empty && summed.isZero(0.0) && window.turn_by_twist == 0.0;
      }
    }
    window = TwistWindow();
    summed.setZero();
    first = i;
  }
  all.twist_is_empty = empty && !all.moving.empty();
  return all;
}

}  // namespace multipath_localization
