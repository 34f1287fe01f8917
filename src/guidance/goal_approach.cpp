#include "multipath_localization/guidance/goal_approach.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kTurning = 6.0;    // in turning circles' radii, that turning round onto the line takes
constexpr double kSettling = 2.0;   // of cruise speed, that coming closer to it takes [s]
constexpr double kOnLine = 0.3;     // of the approach, aside [m] ...
constexpr double kAlongLine = 0.3;  // ... and turned against it [rad]

/// Whether a base goes on along the line by itself: it is on it, behind the goal.
bool on_line(const Pose2& pose_in_goal) {
  return pose_in_goal.x < 0.0 && std::abs(pose_in_goal.y) < kOnLine &&
         std::abs(pose_in_goal.yaw) < kAlongLine;
}

}  // namespace

std::vector<Eigen::Vector2d> approach(const Goal& goal, const std::optional<Pose2>& pose,
                                      const WaypointFollowerParameters& parameters) {
  if (!goal.heading || parameters.limits.differential()) return {goal.position};
  const Pose2 at_goal{goal.position.x(), goal.position.y(), *goal.heading};
  if (pose && on_line(inverse(at_goal) * *pose)) return {goal.position};
  const double run_up = parameters.switch_radius + kTurning / parameters.tightest_curvature() +
                        kSettling * parameters.cruise_speed;
  return {at_goal * Eigen::Vector2d(-run_up, 0.0), goal.position};
}

}  // namespace multipath_localization
