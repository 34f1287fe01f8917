#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "../models/sky.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/localization/localizer.hpp"

namespace multipath_localization {

/// A robot on a winding road under thirteen satellites: odometry at 10 Hz, pseudoranges at up to that rate,
/// delivered late by `latency`.
class PseudorangeDrive {
 public:
  explicit PseudorangeDrive(std::uint64_t seed) : seed_(seed) {}

  Pose2 truth{40.0, -25.0, 2.0};
  double height = 12.0;
  Eigen::Vector2d antenna = Eigen::Vector2d::Zero();
  double speed = 5.0;
  bool wheels = true;    ///< else the odometry says that nothing moves
  bool doppler = false;  ///< whether there are range rates
  int steps_per_epoch = 2;
  double noise = 1.0;    ///< white, of each pseudorange [m]
  double latency = 0.0;  ///< [s]
  double time = 0.0;
  /// Changes an epoch before it is delivered: reflections, outages.
  std::function<void(std::vector<SatelliteObservation>&)> disturb = [](auto&) {};

  void run(
      Localizer& localizer, double duration, const std::function<void()>& observe = [] {}) {
    const auto steps = std::lround(duration / kStep);
    for (long i = 0; i < steps; ++i) {
      localizer.add(drive());
      if (step_ % static_cast<std::uint32_t>(steps_per_epoch) == 0) underway_.push_back(epoch());
      while (!underway_.empty() && underway_.front().stamp + latency < time + 1e-9) {
        localizer.add(Measurement(underway_.front()));
        underway_.pop_front();
      }
      observe();
    }
  }

  [[nodiscard]] double error(const Localizer& localizer) const {
    return (localizer.estimate().pose.position() - truth.position()).norm();
  }

  /// What the receiver measures now.
  [[nodiscard]] PseudorangeEpoch epoch() const {
    RandomStream random(seed_, step_, 2);
    const Eigen::Vector2d position = truth * antenna;
    const Eigen::Vector3d at(position.x(), position.y(), height);
    PseudorangeEpoch epoch;
    epoch.stamp = time;
    epoch.antenna_in_base = antenna;
    epoch.observations = observed(open_sky(), at, 5e4 + 30.0 * time, 5e4 + 30.0 * time - 7.0);
    if (doppler) epoch.observations = with_doppler(epoch.observations, at, velocity(), 30.0);
    for (SatelliteObservation& observation : epoch.observations) {
      observation.pseudorange += noise * random.normal();
      observation.range_rate += 0.05 * random.normal();
    }
    disturb(epoch.observations);
    return epoch;
  }

 private:
  static constexpr double kStep = 0.1;

  [[nodiscard]] double yaw_rate() const { return speed == 0.0 ? 0.0 : 0.2 * std::sin(0.2 * time); }

  [[nodiscard]] Eigen::Vector3d velocity() const {
    const Eigen::Vector2d in_base(speed - yaw_rate() * antenna.y(), yaw_rate() * antenna.x());
    const Eigen::Vector2d in_map = rotation(truth.yaw) * in_base;
    return {in_map.x(), in_map.y(), 0.0};
  }

  OdometryIncrement drive() {
    time = kStep * ++step_;
    const OdometryIncrement u{time, kStep, speed, yaw_rate()};
    truth = truth * displacement(u);
    return wheels ? u : OdometryIncrement{time, kStep, 0.0, 0.0};
  }

  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  std::deque<PseudorangeEpoch> underway_;
};

}  // namespace multipath_localization
