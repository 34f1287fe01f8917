#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "../../models/sky.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization {

/// A vehicle on a winding road under thirteen satellites, some of which may be delayed; odometry at 10 Hz
/// with constant errors.
class SatelliteDrive {
 public:
  explicit SatelliteDrive(std::uint64_t seed) : seed_(seed) {}

  Pose2 truth{40.0, -25.0, 2.2};
  OdometerErrors errors{0.01, 0.002};
  double up = 12.0;
  double speed = 5.0;
  double time = 0.0;
  double clock = -136902.0;
  double drift = -33.0;
  double offset = -6.0;
  double range_sigma = 1.5;
  int steps_per_epoch = 2;  ///< 0: no epochs
  bool doppler = false;
  Eigen::Vector2d antenna = Eigen::Vector2d(0.5, 0.2);
  std::vector<SatelliteObservation> sky = open_sky();
  std::vector<std::size_t> delayed;  ///< indices into the sky
  double delay = 45.0;               ///< [m]
  std::vector<double> biases;        ///< that satellites of the sky keep, of all or none [m]

  OdometryIncrement drive() {
    time = kStep * ++steps_;
    clock += drift * kStep;
    const OdometryIncrement measured{time, kStep, speed,
                                     speed == 0.0 ? errors.gyro_bias : 0.25 * std::sin(0.15 * time)};
    if (!standing(measured)) truth = moved(truth, measured, errors);
    last_ = measured;
    return measured;
  }

  [[nodiscard]] PseudorangeEpoch epoch() const {
    const Eigen::Vector2d base = truth * antenna;
    const Eigen::Vector3d position(base.x(), base.y(), up);
    PseudorangeEpoch epoch;
    epoch.stamp = time;
    epoch.antenna_in_base = antenna;
    epoch.observations = observed(sky, position, clock, clock + offset);
    const OdometryIncrement u = without_errors(last_, errors);
    const Eigen::Vector2d velocity =
        rotation(truth.yaw) * Eigen::Vector2d(u.speed - u.yaw_rate * antenna.y(), u.yaw_rate * antenna.x());
    RandomStream random(seed_, steps_, 2);
    for (SatelliteObservation& observation : epoch.observations) {
      observation.pseudorange += range_sigma * random.normal();
      if (!doppler) continue;
      const Eigen::Vector3d sight = (observation.position - position).normalized();
      observation.range_rate =
          sight.dot(observation.velocity) - sight.head<2>().dot(velocity) + drift + 0.1 * random.normal();
    }
    for (std::size_t i = 0; i < biases.size(); ++i) epoch.observations[i].pseudorange += biases[i];
    for (const std::size_t i : delayed) {
      epoch.observations[i].pseudorange += delay;
      epoch.observations[i].cn0 = 38.0;
    }
    return epoch;
  }

  void run(
      Estimator& filter, double duration, const std::function<void()>& observe = [] {}) {
    const auto steps = std::lround(duration / kStep);
    for (long i = 0; i < steps; ++i) {
      filter.predict(drive());
      if (steps_per_epoch == 0 || steps_ % static_cast<std::uint32_t>(steps_per_epoch) != 0) continue;
      last = filter.update(epoch());
      observe();
    }
  }

  [[nodiscard]] double error(const Estimator& filter) const {
    return (filter.estimate().pose.position() - truth.position()).norm();
  }
  [[nodiscard]] double heading_error(const Estimator& filter) const {
    return std::abs(angle_difference(filter.estimate().pose.yaw, truth.yaw));
  }

  Innovation last;

 private:
  static constexpr double kStep = 0.1;

  std::uint64_t seed_;
  std::uint32_t steps_ = 0;
  OdometryIncrement last_;
};

}  // namespace multipath_localization
