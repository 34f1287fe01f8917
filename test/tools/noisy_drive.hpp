#pragma once

#include <cmath>
#include <cstdint>

#include "evaluation/drive.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/gauss_markov.hpp"
#include "tools/tuning/fix_sequence.hpp"

namespace multipath_localization {

/// What a robot records that drives winding roads at 2 m/s with a known noise: odometry at 20 Hz, 1 % and
/// 0.003 rad/s off, and fixes at 5 Hz whose stamps are `delay` late.
struct NoisyDrive {
  SensorNoise noise;
  double duration = 300.0;  ///< [s]
  double delay = 0.0;       ///< [s]

  [[nodiscard]] Drive record(std::uint64_t seed) const {
    constexpr double kStep = 0.05;
    constexpr int kStepsPerFix = 4;
    RandomStream random(seed, 0, 0);
    GaussMarkov2 wander(noise.wander, noise.wander_time, random);
    Pose2 truth{0.0, 0.0, 6.0 * random.uniform()};
    Drive drive;
    const auto steps = static_cast<int>(duration / kStep);
    for (int i = 1; i <= steps; ++i) {
      const double time = 10.0 + kStep * i;
      const double speed = 1.5 + std::sin(0.3 * time), yaw_rate = 0.3 * std::sin(0.11 * time);
      truth = truth * displacement({time, kStep, speed, yaw_rate});
      const double along = noise.distance * std::sqrt(std::abs(speed) / kStep) * random.normal();
      const double turn = noise.yaw / std::sqrt(kStep) * random.normal();
      drive.odometry.push_back({time, kStep, 1.01 * speed + along, yaw_rate + 0.003 + turn});
      wander.step(kStep, random);
      if (i % kStepsPerFix != 0) continue;
      GnssFix fix;
      fix.stamp = time + delay;
      fix.position = truth.position() + wander.value() + normal2(random, noise.white);
      drive.measurements.push_back({fix, time + delay});
    }
    return drive;
  }
};

}  // namespace multipath_localization
