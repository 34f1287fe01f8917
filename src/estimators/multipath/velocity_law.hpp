#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "multipath_localization/core/random.hpp"

namespace multipath_localization::multipath {

/// Delays that a velocity may have, a tenth of a second apart: half a second is a receiver's own filter.
constexpr std::size_t kDelays = 6;
constexpr double kDelayStep = 0.1;  // [s]

/// What the velocities of a receiver are off by: one guess, carried by a hypothesis, equation (18).
struct VelocityLaw {
  bool drawn = false;         ///< whether there has been a velocity since the hypothesis began
  bool believed = false;      ///< otherwise they say nothing: of another frame, of another sign, frozen
  bool outlier = false;       ///< the last one was one
  bool seeks_course = false;  ///< the heading is any, and the first velocity tells it
  double white = 1.0;         ///< white error [declared sigma]
  double slow = 1.0;          ///< slow error [declared sigma]
  double slow_time = 1.0;     ///< its correlation time [s]
  /// Of the way by odometry since the last velocities, covariance in map [m^2].
  Eigen::Matrix2d way_noise = Eigen::Matrix2d::Zero();
  Eigen::Vector2d unseen =
      Eigen::Vector2d::Zero();  ///< way beyond that of the wheels, since the last fix [m]
  double seen_time = 0.0;       ///< of that, in which velocities came [s]
  std::size_t delay = 0;        ///< it is the velocity of so many steps of kDelayStep before its stamp

  void forget_way() {
    unseen.setZero();
    seen_time = 0.0;
  }
};

/// Draws all of a law but whether it is believed and whether it seeks a course.
void draw_velocity_errors(VelocityLaw& law, RandomStream& random);

/// Lets the law change within `duration` [s].
void wander(VelocityLaw& law, double duration, RandomStream& random);

}  // namespace multipath_localization::multipath
