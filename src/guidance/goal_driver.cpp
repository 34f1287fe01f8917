#include "multipath_localization/guidance/goal_driver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "guidance/goal_detours.hpp"
#include "guidance/rehearsal.hpp"

namespace multipath_localization {

namespace {

constexpr int kMostWays = 3;         // to one end, lest a base that is pushed about turns round for ever
constexpr double kRoundTrip = 15.0;  // turning circles' radii: turned round and on the line again
constexpr double kSettled = 10.0;    // settling lengths likewise
constexpr double kBraking = 0.8;     // of the deceleration allowed
constexpr double kStrayStep = 0.25;  // between looks how far a way leads aside [m]

PathPlan plan_to_end(PathPlan plan) {
  const double speed = plan.zones.empty() ? std::numeric_limits<double>::infinity() : plan.zones.back().speed;
  plan.zones = {{std::numeric_limits<double>::infinity(), speed}};
  return plan;
}

}  // namespace

GoalDriver::GoalDriver(const WaypointFollowerParameters& parameters, PathProgress progress,
                       const PathPlan& plan)
    : parameters_(parameters),
      plan_(plan_to_end(plan)),
      driver_(parameters, std::move(progress), plan),
      ways_left_(kMostWays) {}

bool GoalDriver::passes(const Pose2& pose) {
  const bool passed = driver_.passes(pose);
  if (!driver_.progress().comes_to_rest()) return passed;
  if (passed) missed_by_ = (pose.position() - driver_.progress().end()).norm();
  const bool beside = passed ? missed_by_ > kAtGoal : !std::exchange(rehearsed_, true) && leads_beside(pose);
  if (!beside || ways_left_-- <= 0) return passed;
  return !take_other_way(pose) && passed;
}

PathCommand GoalDriver::command(const Pose2& pose, double most) {
  const PathCommand wanted = driver_.command(pose, most);
  last_ = wanted.command;
  return wanted;
}

bool GoalDriver::leads_beside(const Pose2& pose) const {
  if (parameters_.limits.differential()) return false;  // it turns at the end, where it has to
  const double left = driver_.progress().path().length() - driver_.progress().station();
  const double enough = kRoundTrip / parameters_.tightest_curvature() +
                        kSettled * driver_.settling_length(parameters_.cruise_speed);
  return left < enough && rehearsed_miss(driver_, pose, last_, parameters_) > kAtGoal;
}

bool GoalDriver::take_other_way(const Pose2& pose) {
  const Eigen::Vector2d goal = driver_.progress().end();
  if (parameters_.limits.differential()) {
    driver_ = along(Path({pose.position(), goal}, driver_.progress().rule().radius));
    return true;
  }
  const double turning_radius = 1.0 / parameters_.tightest_curvature();
  const double braking = last_.speed * last_.speed / (2.0 * kBraking * parameters_.limits.max_deceleration);
  for (const double radii : {1.2, 1.6, 2.4}) {
    const double radius = radii * turning_radius;
    const std::vector<double> run_ups = {0.0, 0.5 * radius, radius, 1.5 * radius, 2.0 * radius, braking};
    for (const Path& way : goal_detours(driver_.leading(pose), goal, radius, run_ups)) {
      const PathDriver other = along(way);
      if (strays(way) || rehearsed_miss(other, pose, last_, parameters_) > kAtGoal) continue;
      driver_ = other;
      return true;
    }
  }
  return false;
}

PathDriver GoalDriver::along(Path path) const {
  return {parameters_, PathProgress(std::move(path), driver_.progress().rule()), plan_};
}

bool GoalDriver::strays(const Path& path) const {
  if (parameters_.max_deviation == 0.0) return false;
  const Path& allowed = driver_.progress().path();
  for (double s = 0.0; s < path.length(); s += kStrayStep) {
    const Eigen::Vector2d place = path.at(s).position;
    const double foot = allowed.nearest(place, 0.0, allowed.length());
    if ((allowed.at(foot).position - place).norm() > parameters_.max_deviation) return true;
  }
  return false;
}

}  // namespace multipath_localization
