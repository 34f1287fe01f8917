#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// A satellite at azimuth (from north, clockwise) and elevation [deg], seen from the origin of map.
inline SatelliteObservation satellite(Constellation constellation, int number, double azimuth_deg,
                                      double elevation_deg) {
  const double azimuth = azimuth_deg * kPi / 180.0;
  SatelliteObservation observation;
  observation.constellation = constellation;
  observation.satellite = number;
  observation.elevation = elevation_deg * kPi / 180.0;
  observation.position = 2.2e7 * Eigen::Vector3d(std::sin(azimuth) * std::cos(observation.elevation),
                                                 std::cos(azimuth) * std::cos(observation.elevation),
                                                 std::sin(observation.elevation));
  observation.velocity = 3000.0 * Eigen::Vector3d(std::cos(azimuth), -std::sin(azimuth), 0.0);
  observation.cn0 = 45.0;
  return observation;
}

/// Eight GPS and five GLONASS satellites well spread.
inline std::vector<SatelliteObservation> open_sky() {
  std::vector<SatelliteObservation> all;
  const std::array<double, 4> elevations = {20.0, 45.0, 70.0, 30.0};
  for (int i = 0; i < 8; ++i) {
    all.push_back(
        satellite(Constellation::kGps, i + 1, 45.0 * i, elevations[static_cast<std::size_t>(i % 4)]));
  }
  for (int i = 0; i < 5; ++i) {
    all.push_back(satellite(Constellation::kGlonass, i + 1, 72.0 * i + 20.0,
                            elevations[static_cast<std::size_t>(i % 3)]));
  }
  return all;
}

/// What a receiver at `antenna` whose clocks are off by `gps` and `glonass` [m] measures without error.
inline std::vector<SatelliteObservation> observed(std::vector<SatelliteObservation> sky,
                                                  const Eigen::Vector3d& antenna, double gps,
                                                  double glonass) {
  for (SatelliteObservation& observation : sky) {
    const double clock = observation.constellation == Constellation::kGps ? gps : glonass;
    observation.pseudorange = (observation.position - antenna).norm() + clock;
  }
  return sky;
}

/// The same with the range rates of an antenna that moves at `velocity`, clocks drifting by `drift` [m/s].
inline std::vector<SatelliteObservation> with_doppler(std::vector<SatelliteObservation> sky,
                                                      const Eigen::Vector3d& antenna,
                                                      const Eigen::Vector3d& velocity, double drift) {
  for (SatelliteObservation& observation : sky) {
    const Eigen::Vector3d direction = (observation.position - antenna).normalized();
    observation.range_rate = direction.dot(observation.velocity - velocity) + drift;
  }
  return sky;
}

}  // namespace multipath_localization
