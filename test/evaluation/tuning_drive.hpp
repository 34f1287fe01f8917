#pragma once

#include <cmath>

#include "multipath_localization/evaluation/drive.hpp"
#include "multipath_localization/simulation/gauss_markov.hpp"

namespace multipath_localization {

/// A robot whose sensors are known: odometry with a constant scale error, gyro bias and random walks, fixes
/// with white and coloured noise.
struct KnownSensors {
  double scale_error = 0.02;   ///< of the odometry's speed over the true one, minus 1
  double gyro_bias = 0.004;    ///< [rad/s]
  double distance = 0.02;      ///< [m/sqrt(m)]
  double yaw = 0.005;          ///< [rad/sqrt(s)]
  double white = 0.3;          ///< [m]
  double coloured = 0.0;       ///< [m]
  double time_constant = 5.0;  ///< [s]
  double delay = 0.0;          ///< of the place a fix shows against its stamp [s]
};

/// `minutes` of winding about at changing speed, odometry at 25 Hz, fixes at 5 Hz that come in at once.
inline Drive tuning_drive(const KnownSensors& sensors, double minutes, std::uint64_t seed) {
  Drive drive;
  Pose2 pose;
  GaussMarkov2 wander(sensors.coloured, sensors.time_constant, RandomStream(seed, 0, 7));
  const double step = 0.04;
  const int steps = static_cast<int>(minutes * 60.0 / step);
  for (int i = 1; i <= steps; ++i) {
    const double stamp = 1e6 + step * i;
    RandomStream random(seed, static_cast<std::uint32_t>(i), 8);
    const double phase = 0.04 * i;
    const OdometryIncrement truth{stamp, step, 1.2 + 0.6 * std::sin(0.5 * phase),
                                  0.4 * std::sin(0.23 * phase)};
    pose = pose * displacement(truth);
    OdometryIncrement measured = truth;
    const double way = std::abs(truth.speed) * step;
    measured.speed = truth.speed * (1.0 + sensors.scale_error) +
                     sensors.distance * std::sqrt(way) * random.normal() / step;
    measured.yaw_rate += sensors.gyro_bias + sensors.yaw * random.normal() / std::sqrt(step);
    drive.odometry.push_back(measured);
    wander.step(step, random);
    if (i % 5 != 0) continue;
    GnssFix fix;
    fix.stamp = stamp + sensors.delay;
    fix.position = pose.position() + wander.value() + normal2(random, sensors.white);
    drive.measurements.push_back({fix, fix.stamp});
  }
  return drive;
}

}  // namespace multipath_localization
