#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "tools/doctor/observations.hpp"

namespace multipath_localization {

/// What odometry says of one short while, by its poses and by its twist.
struct TwistWindow {
  double duration = 0.0;                               ///< [s]
  double yaw = 0.0;                                    ///< by pose, in the middle [rad]
  Eigen::Vector2d by_pose = Eigen::Vector2d::Zero();   ///< way along x and y of the base, as on an arc [m]
  Eigen::Vector2d by_twist = Eigen::Vector2d::Zero();  ///< likewise
  /// Likewise, if the twist were in the frame of the poses, not in that of the base.
  Eigen::Vector2d by_twist_in_odom = Eigen::Vector2d::Zero();
  double turn_by_pose = 0.0;   ///< [rad]
  double turn_by_twist = 0.0;  ///< [rad]

  [[nodiscard]] bool moves() const;
};

/// Twist against the differences of the poses.
struct TwistComparison {
  std::vector<TwistWindow> moving;  ///< in which either says that the robot moves
  std::size_t messages = 0;
  std::size_t without_orientation = 0;  ///< messages whose quaternion is all zero
  bool twist_is_empty = false;          ///< all of it, of a robot that moves

  /// Sums over the windows of a figure of theirs.
  template <class Figure>
  [[nodiscard]] double sum(const Figure& figure) const {
    double all = 0.0;
    for (const TwistWindow& window : moving) all += figure(window);
    return all;
  }
};

/// Over windows of a fifth of a second or more, so that neither stamps that come in bursts or twice nor a
/// twist that lags count.
TwistComparison compare_twist(const Observations& seen);

}  // namespace multipath_localization
