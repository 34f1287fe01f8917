#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/evaluation/metrics.hpp"
#include "nodes/conversions.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {

namespace {

constexpr double kMoving = 0.05;   // [m/s]
constexpr double kTurning = 0.05;  // [rad/s]
constexpr std::size_t kEnoughSamples = 20;
constexpr double kScaleTolerance = 0.1;
constexpr double kTurnChord = 4.0;   // [m]
constexpr double kSharpTurn = 0.35;  // between two chords, 20 degrees [rad]
constexpr std::size_t kEnoughTurns = 4;
constexpr double kScaleChord = 10.0;  // [m]
constexpr std::size_t kEnoughChords = 5;

/// Twist against the difference of the poses, message by message.
struct TwistComparison {
  std::vector<double> speed_ratios;     ///< twist over pose
  std::vector<double> yaw_rate_ratios;  ///< twist over pose
  std::size_t empty = 0;                ///< moves by its pose, but not by its twist
  std::size_t moving = 0;
};

void compare(const nav_msgs::Odometry& before, const nav_msgs::Odometry& now, TwistComparison& all) {
  const double duration = now.header.stamp.toSec() - before.header.stamp.toSec();
  const std::optional<Pose2> from = to_pose2(before.pose.pose);
  const std::optional<Pose2> to = to_pose2(now.pose.pose);
  if (duration <= 0.0 || !from || !to) return;
  const Pose2 moved = inverse(*from) * *to;
  const geometry_msgs::Twist& twist = now.twist.twist;
  const double speed = moved.x / duration;
  const double yaw_rate = moved.yaw / duration;
  if (std::abs(speed) > kMoving || std::abs(yaw_rate) > kTurning) {
    ++all.moving;
    if (twist.linear.x == 0.0 && twist.angular.z == 0.0) ++all.empty;
  }
  if (std::abs(speed) > kMoving) all.speed_ratios.push_back(twist.linear.x / speed);
  if (std::abs(yaw_rate) > kTurning) all.yaw_rate_ratios.push_back(twist.angular.z / yaw_rate);
}

Finding ratio_of(const std::string& name, const std::vector<double>& ratios) {
  if (ratios.size() < kEnoughSamples)
    return untold("odom: too little motion to compare " + name + " with the pose");
  const double ratio = quantile(ratios, 0.5);
  const std::size_t opposite = static_cast<std::size_t>(
      std::count_if(ratios.begin(), ratios.end(), [](double r) { return r < -0.5; }));
  const std::string what = text("odom: %s is %.2f times what the pose does", name.c_str(), ratio);
  if (ratio < -0.5) return fix(what, "in the base driver: turn the sign of " + name);
  if (20 * opposite > ratios.size()) {
    return fix(text("odom: %s has the other sign than the pose in %.0f %% of the messages, as of a speed "
                    "without sign in reverse",
                    name.c_str(), 100.0 * static_cast<double>(opposite) / static_cast<double>(ratios.size())),
               "in the base driver: " + name + " negative in reverse");
  }
  if (std::abs(ratio - 1.0) > kScaleTolerance)
    return fix(what, text("in the base driver: %s times %.3f", name.c_str(), 1.0 / ratio));
  return pass(what);
}

double direction(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

}  // namespace

Findings check_twist(const Observations& seen) {
  TwistComparison all;
  for (std::size_t i = 1; i < seen.odometry.size(); ++i) {
    compare(seen.odometry[i - 1].message, seen.odometry[i].message, all);
  }
  if (all.moving >= kEnoughSamples && all.empty == all.moving) {
    return {pass("odom: the twist is empty, so the motion is that of the poses")};
  }
  return {ratio_of("twist.linear.x", all.speed_ratios), ratio_of("twist.angular.z", all.yaw_rate_ratios)};
}

Findings check_turns(const Observations& seen) {
  const Motion motion = motion_of(seen);
  const std::vector<Chord> all = chords(motion.fixes, motion.track, kTurnChord);
  std::size_t alike = 0, opposite = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double course = angle_difference(direction(all[i].by_fixes), direction(all[i - 1].by_fixes));
    const double odometry =
        angle_difference(direction(all[i].by_odometry), direction(all[i - 1].by_odometry));
    const bool follows = all[i].start == all[i - 1].end;
    if (!follows || std::abs(odometry) < kSharpTurn || std::abs(odometry) > 0.9 * kPi) continue;
    if (std::abs(course - odometry) < std::abs(course + odometry))
      ++alike;
    else
      ++opposite;
  }
  if (alike + opposite < kEnoughTurns)
    return {untold("odom: too few turns to tell left from right; drive a figure of eight")};
  const std::string what = text("odom: %zu of %zu turns go the same way round as the course of the fixes",
                                alike, alike + opposite);
  if (alike >= 2 * opposite) return {pass(what)};
  if (opposite >= 2 * alike) {
    return {fix(what + ": mirrored, or NED",
                "in the base driver: yaw counter-clockwise, x forwards, y to the left (REP-103): yaw = -yaw, "
                "angular.z = -angular.z, y = -y")};
  }
  return {untold(what + ": the fixes scatter too much to tell")};
}

Findings check_scale(const Observations& seen) {
  const Motion motion = motion_of(seen);
  std::vector<double> ratios;
  for (const Chord& chord : chords(motion.fixes, motion.track, kScaleChord)) {
    ratios.push_back(chord.by_fixes.norm() / chord.by_odometry.norm());
  }
  if (ratios.size() < kEnoughChords) return {untold("odom: too little driving with fixes to tell its scale")};
  const double ratio = quantile(ratios, 0.5);
  const std::string what =
      text("odom: fixes go %.3f times as far, over %zu pieces of %.0f m", ratio, ratios.size(), kScaleChord);
  if (std::abs(ratio - 1.0) <= kScaleTolerance) return {pass(what)};
  return {fix(what, text("in the base driver: wheel radius (metres per tick) times %.3f", ratio))};
}

}  // namespace multipath_localization
