#include "multipath_localization/guidance/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath_localization {

namespace {

/// To keep to each of the obstacles: none to what is within it already.
std::vector<double> clearances(const Pose2& pose, const Footprint& footprint,
                               const std::vector<Eigen::Vector2d>& obstacles) {
  const Pose2 to_base = inverse(pose);
  std::vector<double> wider;
  for (const Eigen::Vector2d& obstacle : obstacles) {
    const bool within = footprint.holds(to_base * obstacle, footprint.side_clearance);
    wider.push_back(within ? 0.0 : footprint.side_clearance);
  }
  return wider;
}

bool touches(const Pose2& pose, const Footprint& footprint, const std::vector<Eigen::Vector2d>& obstacles,
             const std::vector<double>& wider) {
  const Eigen::Matrix2d to_base = rotation(-pose.yaw);
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    if (footprint.holds(to_base * (obstacles[k] - pose.position()), wider[k])) return true;
  }
  return false;
}

}  // namespace

void Footprint::fields(ParameterVisitor& field) {
  field("front", front, {0.0, 20.0}, "m",
        "from the base's origin, the middle of its rear axle, to its front end");
  field("rear", rear, {0.0, 20.0}, "m", "and to its rear end");
  field("width", width, {0.01, 20.0}, "m", "of the robot");
  field("side_clearance", side_clearance, {0.0, 5.0}, "m", "to what the robot passes by, on either side");
}

bool Footprint::holds(const Eigen::Vector2d& point, double wider) const {
  return point.x() >= -rear && point.x() <= front && std::abs(point.y()) <= 0.5 * width + wider;
}

double Footprint::radius() const { return std::hypot(std::max(front, rear), 0.5 * width); }

double free_way(const std::vector<Pose2>& way, const Footprint& footprint,
                const std::vector<Eigen::Vector2d>& obstacles) {
  const std::vector<double> wider = clearances(way.front(), footprint, obstacles);
  double gone = 0.0;  // up to the pose before: free for certain
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i > 1) gone += (way[i - 1].position() - way[i - 2].position()).norm();
    if (touches(way[i], footprint, obstacles, wider)) return gone;
  }
  return std::numeric_limits<double>::infinity();
}

bool free_to_turn(const Pose2& pose, const Footprint& footprint,
                  const std::vector<Eigen::Vector2d>& obstacles) {
  return std::none_of(obstacles.begin(), obstacles.end(), [&](const Eigen::Vector2d& obstacle) {
    return (obstacle - pose.position()).norm() < footprint.radius();
  });
}

}  // namespace multipath_localization
