#pragma once

#include <array>
#include <cstddef>

namespace multipath_localization {

/// One way in which a hypothesis may hold that the robot moves: how large the velocity is that the odometry
/// does not see, an Ornstein-Uhlenbeck process for each axis of the map.
struct MotionLaw {
  double velocity_sigma = 0.0;  ///< 1 sigma of it in the long run [m/s]
  double velocity_time = 1.0;   ///< its correlation time [s], > 0
  double yaw_noise = 0.0;       ///< of the heading, beside the odometry's own [rad/sqrt(s)]
  bool always = false;          ///< whether it goes on while the odometry says that the robot stands
};

inline constexpr std::size_t kMotionLaws = 4;

/// The laws that a hypothesis weighs against each other, and how one follows another.
struct MotionLaws {
  std::array<MotionLaw, kMotionLaws> laws;
  std::array<double, kMotionLaws> starting;  ///< probability of each at the start
  std::array<double, kMotionLaws> leaving;   ///< rate at which each ends [1/s]
  std::array<double, kMotionLaws> entering;  ///< how likely each is to be the next, in proportion

  using Matrix = std::array<std::array<double, kMotionLaws>, kMotionLaws>;
  /// Probability of law j after `dt` [s] of law i, as [i][j].
  [[nodiscard]] Matrix transitions(double dt) const;
};

/// Of a robot with wheels: odometry as good as a calibrated car's, five and 25 times worse, and none.
const MotionLaws& laws_of_wheels();

/// Of a robot that nothing but the range rates of satellites tells of: standing, and as a car drives calmly,
/// in traffic and at its limits.
const MotionLaws& laws_without_wheels();

}  // namespace multipath_localization
