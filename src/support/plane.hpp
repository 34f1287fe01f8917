#pragma once

#include <Eigen/Core>

namespace multipath_localization {

/// The third component of the cross product of two vectors in the plane: positive where `b` lies to the left
/// of `a`.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace multipath_localization
