#include <algorithm>
#include <cmath>
#include <complex>

#include "evaluation/metrics.hpp"
#include "multipath_localization/core/angle.hpp"
#include "tools/doctor/checks.hpp"
#include "tools/doctor/shape_fit.hpp"
#include "tools/doctor/twist_comparison.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kEnoughWindows = 10;
constexpr double kScaleTolerance = 0.1;
constexpr double kSteadyRatio = 0.1;   // half of what lies between the quartiles of one ratio
constexpr double kFits = 0.02;         // of the squares of the way, left by an explanation that holds
constexpr double kClearly = 0.2;       // of what another leaves, left by one that is better
constexpr double kMisses = 0.05;       // of the squares of the way, left by one that does not hold
constexpr double kTurnedAxes = 0.17;   // 10 degrees [rad]
constexpr double kManyHeadings = 0.9;  // length of the mean direction of headings that differ
constexpr double kSideways = 0.1;      // of the way, of a base that moves sideways
constexpr double kMostlyAlong = 0.7;   // of a way, of one that is no way sideways
constexpr double kPartlyAside = 0.3;   // of a way, of one that is sideways beyond what noise makes of it
constexpr double kTurns = 0.05;        // [rad/s]
constexpr double kRolls = 0.05;        // [m/s]
constexpr double kClearTurn = 1.0;     // that neither noise nor a gyro's bias is [rad]
constexpr char kFillOrientation[] =
    "in the base driver: pose.pose.orientation = tf::createQuaternionMsgFromYaw(yaw)";

/// Which of the two voices of the odometry goes the way of the fixes.
struct Judgement {
  bool poses = false;
  bool twist = false;
};

Judgement judged(const Observations& seen) {
  const auto fits = [&](Voice voice) {
    const Motion motion = motion_of(seen, voice);
    return fit_shape(motion.fixes, motion.track);
  };
  const ShapeFit poses = fits(Voice::kPoses);
  const ShapeFit twist = fits(Voice::kTwist);
  return {poses.fits() && poses.rigid_error < twist.rigid_error * 1.2,
          twist.fits() && twist.rigid_error < poses.rigid_error * 1.2};
}

/// The remedy for the one that the fixes contradict; where they contradict neither or both, how to tell.
std::string remedy_of(const Judgement& right, const std::string& of_twist, const std::string& of_pose,
                      const std::string& how_to_tell) {
  if (right.poses && !right.twist) return "in the base driver: " + of_twist;
  if (right.twist && !right.poses) return "in the base driver: " + of_pose;
  return "in the base driver, either " + of_twist + ", or " + of_pose + ": " + how_to_tell;
}

double squares_of_way(const TwistComparison& all) {
  return all.sum([](const TwistWindow& w) { return w.by_pose.squaredNorm(); });
}

/// What is left of the way by pose where the way is told by `way` of each window, as a share of its squares.
template <class Way>
double left_by(const TwistComparison& all, const Way& way) {
  return all.sum([&](const TwistWindow& w) { return (w.by_pose - way(w)).squaredNorm(); }) /
         squares_of_way(all);
}

Eigen::Vector2d in_base(const TwistWindow& window) { return window.by_twist; }
Eigen::Vector2d in_odom(const TwistWindow& window) { return window.by_twist_in_odom; }

bool many_headings(const TwistComparison& all) {
  std::complex<double> mean;
  for (const TwistWindow& window : all.moving) mean += std::polar(1.0, window.yaw);
  return std::abs(mean) < kManyHeadings * static_cast<double>(all.moving.size());
}

/// By how much the twist's axes are turned against those of the poses, its length being right [rad].
double turned_by(const TwistComparison& all) {
  std::complex<double> product;
  for (const TwistWindow& w : all.moving) {
    product += std::complex<double>(w.by_pose.x(), w.by_pose.y()) *
               std::conj(std::complex<double>(w.by_twist.x(), w.by_twist.y()));
  }
  return std::arg(product);
}

/// The furthest that the twist turns from its heading at the start while the poses lead along a curve and
/// never turn; 0 where they do [rad].
double turn_untold_by_poses(const TwistComparison& all) {
  double heading = 0.0, furthest = 0.0;
  std::complex<double> directions;  // of doubled angles: back is along the same line
  double windows = 0.0;
  for (const TwistWindow& w : all.moving) {
    if (w.turn_by_pose != 0.0) return 0.0;
    heading += w.turn_by_twist;
    furthest = std::max(furthest, std::abs(heading));
    if (w.by_pose.isZero(0.0)) continue;
    directions += std::polar(1.0, 2.0 * std::atan2(w.by_pose.y(), w.by_pose.x()));
    ++windows;
  }
  return std::abs(directions) < kManyHeadings * windows ? furthest : 0.0;
}

/// Twist whose axes are not those of the base, empty for none.
Findings frame_of_twist(const TwistComparison& all) {
  const double base = left_by(all, in_base);
  if (base < kMisses) return {};
  const double odom = left_by(all, in_odom);
  if (odom < kFits && odom < kClearly * base && many_headings(all)) {
    return {
        fix("odom: the twist is in the frame of the poses, not in that of the base",
            "in the base driver: turn twist.linear by -yaw: x = vx cos(yaw) + vy sin(yaw), y = vy cos(yaw) - "
            "vx sin(yaw)")};
  }
  const double angle = turned_by(all);
  const double turned =
      left_by(all, [&](const TwistWindow& w) -> Eigen::Vector2d { return rotation(angle) * w.by_twist; });
  const bool reversed = std::abs(angle) > kPi - kTurnedAxes;
  if (turned > kFits || turned > kClearly * base || std::abs(angle) < kTurnedAxes || reversed) return {};
  const std::string what =
      text("odom: twist.linear points %.0f degrees beside the way of the poses", -angle * 180.0 / kPi);
  if (odom < kFits) {
    return {fix(what,
                "drive a circle and look again: in the base driver, the twist is in the frame of the poses "
                "if that angle then changes with the heading, else its x is not the base's, or the yaw of "
                "the poses is not")};
  }
  return {fix(what,
              "in the base driver: x forwards and y to the left (REP-103), in the twist or in the yaw of the "
              "poses: drive forwards, and see whether twist.linear.x is the speed")};
}

/// Ways sideways, by twist and by pose [m].
struct Sideways {
  double way = 0.0;  ///< in all directions
  double by_pose = 0.0;
  double by_twist = 0.0;
  bool pose = false;   ///< it moves so by its poses
  bool twist = false;  ///< it moves so by its twist
};

Sideways moves_sideways(const TwistComparison& all) {
  Sideways moves;
  moves.way = all.sum([](const TwistWindow& w) { return w.by_pose.norm(); });
  moves.by_pose = all.sum([](const TwistWindow& w) { return std::abs(w.by_pose.y()); });
  moves.by_twist = all.sum([](const TwistWindow& w) { return std::abs(w.by_twist.y()); });
  moves.pose = moves.by_pose > kSideways * moves.way;
  moves.twist = moves.by_twist > kSideways * moves.way;
  return moves;
}

Findings motion_sideways(const TwistComparison& all, const Observations& seen) {
  const auto [way, by_pose, by_twist, pose_moves, twist_moves] = moves_sideways(all);
  if (!pose_moves && !twist_moves) return {};
  if (pose_moves && twist_moves) {
    return {pass(text("odom: moves sideways too, %.1f of %.1f m", by_pose, way))};
  }
  const Judgement right = judged(seen);
  if (pose_moves) {
    return {fix(text("odom: the poses move %.1f of %.1f m sideways, of which twist.linear.y knows nothing",
                     by_pose, way),
                remedy_of(right, "fill twist.linear.y", "no motion sideways in the poses",
                          "push the robot to its side, if it can: which of them moves?"))};
  }
  const std::string what =
      text("odom: twist.linear.y says %.1f m sideways, of which the poses know nothing", by_twist);
  if (right.poses && !right.twist) return {fix(what, "localization.yaml, odometry: {lateral: false}")};
  return {fix(what,
              right.twist && !right.poses
                  ? std::string("in the base driver: add twist.linear.y up in the poses")
                  : std::string("for a base that cannot move sideways localization.yaml, odometry: {lateral: "
                                "false}; for one that can, add twist.linear.y up in the poses"))};
}

/// A component of twist against that of the poses, window by window.
struct Ratios {
  std::string name;      ///< of the twist's
  std::string of_poses;  ///< the same of the poses
  std::string forwards;  ///< a motion of which it is positive
  std::vector<double> all;
  bool twist_goes_back = false;  ///< it is negative at times
};

Ratios speeds(const TwistComparison& comparison) {
  Ratios ratios{"twist.linear.x", "the poses' way", "drive forwards", {}, false};
  for (const TwistWindow& w : comparison.moving) {
    const bool along = std::abs(w.by_pose.x()) > kMostlyAlong * w.by_pose.norm();
    if (!along || std::abs(w.by_pose.x()) < kRolls * w.duration) continue;
    ratios.all.push_back(w.by_twist.x() / w.by_pose.x());
    ratios.twist_goes_back = ratios.twist_goes_back || w.by_twist.x() < -kRolls * w.duration;
  }
  return ratios;
}

Ratios speeds_sideways(const TwistComparison& comparison) {
  Ratios ratios{"twist.linear.y", "the poses' way to the side", "push the robot to its left", {}, false};
  for (const TwistWindow& w : comparison.moving) {
    const bool aside = std::abs(w.by_pose.y()) > kPartlyAside * w.by_pose.norm();
    if (!aside || std::abs(w.by_pose.y()) < kRolls * w.duration) continue;
    ratios.all.push_back(w.by_twist.y() / w.by_pose.y());
    ratios.twist_goes_back = ratios.twist_goes_back || w.by_twist.y() < -kRolls * w.duration;
  }
  return ratios;
}

Ratios yaw_rates(const TwistComparison& comparison) {
  Ratios ratios{"twist.angular.z", "the poses' yaw", "turn left", {}, false};
  for (const TwistWindow& w : comparison.moving) {
    if (std::abs(w.turn_by_pose) < kTurns * w.duration) continue;
    ratios.all.push_back(w.turn_by_twist / w.turn_by_pose);
    ratios.twist_goes_back = ratios.twist_goes_back || w.turn_by_twist < -kTurns * w.duration;
  }
  return ratios;
}

/// Where the signs of twist and poses differ at times.
Finding signs_of(const Ratios& ratios, double opposite) {
  const std::string what = text("odom: %s has the other sign than the pose in %.0f %% of the messages",
                                ratios.name.c_str(), 100.0 * opposite);
  if (!ratios.twist_goes_back) {
    return fix(what + " and is never negative: a speed without sign",
               "in the base driver: " + ratios.name + " negative in reverse, and to the right");
  }
  return untold(what + ", and is negative at times: these messages do not tell why");
}

Finding ratio_of(const Ratios& ratios, const Observations& seen) {
  if (ratios.all.size() < kEnoughWindows)
    return untold("odom: too little motion to compare " + ratios.name + " with the pose");
  const auto count = static_cast<double>(ratios.all.size());
  const double ratio = quantile(ratios.all, 0.5);
  const double opposite = static_cast<double>(std::count_if(ratios.all.begin(), ratios.all.end(),
                                                            [](double r) { return r < -0.5; })) /
                          count;
  const std::string what = text("odom: %s is %.2f times what the pose does", ratios.name.c_str(), ratio);
  if (opposite > 0.05 && opposite < 0.95) return signs_of(ratios, opposite);
  const double spread = 0.5 * (quantile(ratios.all, 0.75) - quantile(ratios.all, 0.25));
  if (spread > kSteadyRatio * std::abs(ratio))
    return untold(what + text(" in the median, give or take %.2f: that is no scale", spread));
  if (ratio > 0.0 && std::abs(ratio - 1.0) <= kScaleTolerance) return pass(what);
  const Judgement right = judged(seen);
  if (ratio < 0.0) {
    return fix(what,
               remedy_of(right, "turn the sign of " + ratios.name, "turn the sign of " + ratios.of_poses,
                         ratios.forwards + ", and see whether " + ratios.name + " is positive"));
  }
  return fix(what, remedy_of(right, ratios.name + text(" times %.3f", 1.0 / ratio),
                             ratios.of_poses + text(" times %.3f", ratio), "measure a way and a turn"));
}

}  // namespace

Findings check_twist(const Observations& seen) {
  const TwistComparison all = compare_twist(seen);
  if (all.without_orientation > 0) {
    return {fix(text("odom: the quaternion of %zu of %zu poses is all zero, which is no orientation",
                     all.without_orientation, all.messages),
                kFillOrientation)};
  }
  if (all.moving.size() >= kEnoughWindows && all.twist_is_empty) {
    return {pass("odom: the twist is empty, so the motion is that of the poses")};
  }
  const double untold_turn = turn_untold_by_poses(all);
  if (untold_turn > kClearTurn) {
    return {fix(text("odom: the poses move but never turn, while twist.angular.z turns by %.0f degrees",
                     untold_turn * 180.0 / kPi),
                kFillOrientation)};
  }
  const bool still = squares_of_way(all) == 0.0;
  Findings findings = still ? Findings() : frame_of_twist(all);
  if (!findings.empty()) return findings;
  if (!still) findings = motion_sideways(all, seen);
  findings.push_back(ratio_of(speeds(all), seen));
  const Ratios sideways = speeds_sideways(all);
  if (sideways.all.size() >= kEnoughWindows && moves_sideways(all).twist)
    findings.push_back(ratio_of(sideways, seen));
  findings.push_back(ratio_of(yaw_rates(all), seen));
  return findings;
}

}  // namespace multipath_localization
