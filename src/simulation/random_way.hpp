#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

/// Where a random robot drives.
enum class Street { kBlock, kTown, kLoop, kStraight, kCurves, kEight, kField };

std::string_view to_string(Street street);

/// An interval of time [s].
struct Interval {
  double start = 0.0;
  double duration = 0.0;

  [[nodiscard]] bool holds(double time) const { return time >= start && time < start + duration; }
};

/// Whether one of the intervals holds `time` [s].
bool any_holds(const std::vector<Interval>& intervals, double time);

/// How a random robot drives, as drawn.
struct RandomWay {
  Street street = Street::kBlock;
  double duration = 0.0;              ///< [s]
  double speed = 1.0;                 ///< on straights [m/s]
  double acceleration = 1.0;          ///< [m/s^2]
  double lateral_acceleration = 1.0;  ///< [m/s^2]
  double radius = 1.0;                ///< of corners [m]
  double straight = 10.0;             ///< between them [m]
  double on_spot_rate = 0.0;          ///< [rad/s] of corners turned on the spot; 0: it drives round them
  double wander = 0.0;                ///< standard deviation of the curvature on straights [1/m]
  double start_speed = 0.0;           ///< [m/s]
  std::vector<Interval> stops;
  std::vector<Interval> reversals;
};

/// Draws a way of that speed [m/s] and duration [s], with corners on the spot and backing up only for robots
/// that can.
RandomWay draw_way(RandomStream& random, double speed, double duration, bool turns_on_spot, bool reverses);

/// Motion over one step of kWayStep: speed and yaw rate throughout, pose at its end.
struct MotionStep {
  Pose2 base_in_map;
  double speed = 0.0;     ///< [m/s]
  double yaw_rate = 0.0;  ///< [rad/s]
};

constexpr int kWayStepMs = 10;
constexpr double kWayStep = 0.001 * kWayStepMs;  ///< [s]

/// Drives the way from the origin, heading anywhere. Deterministic by (way, seed).
std::vector<MotionStep> drive_way(const RandomWay& way, std::uint64_t seed);

}  // namespace multipath_localization
