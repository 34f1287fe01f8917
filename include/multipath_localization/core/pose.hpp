#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

/// Where a robot can still be said to be, from the origin of map along each axis [m].
constexpr double kFurthestPose = 1e7;

/// A planar pose, or the transform that it is: position in metres, yaw in radians counter-clockwise.
struct Pose2 {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;

  [[nodiscard]] Eigen::Vector2d position() const { return {x, y}; }
  [[nodiscard]] bool finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(yaw); }
};

/// R(yaw) of size 2x2: turns a vector from the body frame to the frame the yaw is measured in.
inline Eigen::Matrix2d rotation(double yaw) {
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

/// Maps a point from the pose's own frame to its parent: `p_in_map = base_in_map * p_in_base`.
inline Eigen::Vector2d operator*(const Pose2& pose, const Eigen::Vector2d& point) {
  return pose.position() + rotation(pose.yaw) * point;
}

/// Composition, names cancel: `c_in_a = b_in_a * c_in_b`. The yaw comes out wrapped.
inline Pose2 operator*(const Pose2& outer, const Pose2& inner) {
  const Eigen::Vector2d p = outer * inner.position();
  return {p.x(), p.y(), wrap_angle(outer.yaw + inner.yaw)};
}

inline Pose2 inverse(const Pose2& pose) {
  const Eigen::Vector2d p = -(rotation(-pose.yaw) * pose.position());
  return {p.x(), p.y(), wrap_angle(-pose.yaw)};
}

}  // namespace multipath_localization
