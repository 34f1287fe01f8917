#include "guidance/goal_detours.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace multipath_localization {

namespace {

/// `angle` within [0, 2 pi).
double counted_on(double angle) {
  const double wrapped = wrap_angle(angle);
  return wrapped < 0.0 ? wrapped + 2.0 * kPi : wrapped;
}

/// Turns to the left, `side` being 1, or to the right, -1; none where the goal lies within the circle.
std::optional<Path> detour(const Pose2& pose, const Eigen::Vector2d& goal, double run_up, double radius,
                           double side) {
  const Eigen::Vector2d centre = pose * Eigen::Vector2d(run_up, side * radius);
  const Eigen::Vector2d to_goal = goal - centre;
  const double distance = to_goal.norm();
  if (distance < radius) return std::nullopt;
  const double begin = pose.yaw - side * 0.5 * kPi;  // seen from the centre
  const double leave = std::atan2(to_goal.y(), to_goal.x()) - side * std::acos(radius / distance);
  const double turn = counted_on(side * (leave - begin));
  const double straight = std::sqrt(distance * distance - radius * radius);
  return Path(pose, {{run_up, 0.0}, {turn * radius, side / radius}, {straight, 0.0}});
}

}  // namespace

std::vector<Path> goal_detours(const Pose2& pose, const Eigen::Vector2d& goal, double radius,
                               const std::vector<double>& run_ups) {
  std::vector<Path> ways;
  for (const double run_up : run_ups) {
    for (const double side : {1.0, -1.0}) {
      if (const auto way = detour(pose, goal, run_up, radius, side)) ways.push_back(*way);
    }
  }
  std::sort(ways.begin(), ways.end(), [](const Path& a, const Path& b) { return a.length() < b.length(); });
  return ways;
}

}  // namespace multipath_localization
