#include "multipath_localization/guidance/path_tracking.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kApproach = 0.8;  // sine of the steepest angle to the path: 53 degrees

}  // namespace

double tracking_curvature(const Pose2& pose, const PathPoint& foot, double curvature_ahead,
                          double settling_length, double tightest_curvature) {
  const double psi = angle_difference(pose.yaw, foot.heading);
  if (std::abs(psi) > 0.5 * kPi) return std::copysign(tightest_curvature, -psi);
  const Eigen::Vector2d left(-std::sin(foot.heading), std::cos(foot.heading));
  const double e = left.dot(pose.position() - foot.position);
  const double approach = std::clamp(0.5 * e / settling_length, -kApproach, kApproach);
  const double bend = std::abs(approach) < kApproach ? curvature_ahead : 0.0;
  const double curvature = bend - 2.0 * (std::sin(psi) + approach) / settling_length;
  return std::clamp(curvature, -tightest_curvature, tightest_curvature);
}

}  // namespace multipath_localization
