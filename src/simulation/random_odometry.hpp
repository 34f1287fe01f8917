#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/random_way.hpp"

namespace multipath_localization {

/// Where a random robot's yaw rate comes from; by Doppler its speed too.
enum class YawSource { kGyro, kWheels, kSkidSteer, kSteering, kDoppler };

std::string_view to_string(YawSource source);

/// Wheels that turn otherwise than the robot moves: by `ratio` of its way more, -1 locked; or an encoder of
/// one side that is dead.
struct WheelFault {
  enum class Kind { kSlip, kLocked, kSpinning, kDeadEncoder };
  Kind kind = Kind::kSlip;
  Interval when;
  double ratio = 0.0;
};

/// Odometry of a random robot, as drawn: standard deviations and what was drawn from them.
struct RandomOdometry {
  YawSource yaw = YawSource::kGyro;
  int period_ms = 20;
  double speed_scale_sigma = 0.0;       ///< [1]
  double speed_scale = 0.0;             ///< measured over true speed, minus 1
  double scale_drift_sigma = 0.0;       ///< [1] of what changes of it
  double scale_drift_time = 1.0;        ///< [s]
  double speed_noise = 0.0;             ///< [sqrt(m)] of way
  double gyro_bias_sigma = 0.0;         ///< [rad/s]
  double gyro_bias = 0.0;               ///< [rad/s] at the start
  double gyro_bias_walk = 0.0;          ///< [rad/s/sqrt(s)]
  double yaw_noise = 0.0;               ///< [rad/sqrt(s)]
  double turn_scale_mean = 0.0;         ///< [1]
  double turn_scale_sigma = 0.0;        ///< [1]
  double turn_scale = 0.0;              ///< measured over true turn, minus 1
  double curvature_offset_sigma = 0.0;  ///< [1/m]
  double curvature_offset = 0.0;        ///< [1/m] turn read for each metre driven
  double tick = 0.0;                    ///< [m]; 0: none
  double wheel_separation = 0.5;        ///< [m]
  double doppler_sigma = 0.0;           ///< [m/s] of a component
  double doppler_time = 1.0;            ///< [s]
  std::vector<WheelFault> faults;

  [[nodiscard]] bool turns_by_wheels() const {
    return yaw == YawSource::kWheels || yaw == YawSource::kSkidSteer;
  }
  /// Whether a fault counts in any part of start..end [s].
  [[nodiscard]] bool faulty(double start, double end) const;
};

/// Draws the kind and the errors of odometry of a robot of that speed [m/s] that drives for `duration` [s].
RandomOdometry draw_odometry(RandomStream& random, double speed, double duration);

/// What odometry reads on a way, and what it would have read without faults of the wheels.
struct ReadOdometry {
  std::vector<OdometryIncrement> increments;
  std::vector<OdometryIncrement> without_faults;
};

/// Deterministic by (odometry, steps, seed).
ReadOdometry read_odometry(const RandomOdometry& odometry, const std::vector<MotionStep>& steps,
                           std::uint64_t seed);

}  // namespace multipath_localization
