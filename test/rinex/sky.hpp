#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "broadcast.hpp"
#include "multipath_localization/core/angle.hpp"
#include "rinex/observation_file.hpp"

namespace multipath_localization {

/// Satellites on circles, evenly spread, each with a clock error and a group delay of its own.
inline std::vector<BroadcastOrbit> circling_satellites(Constellation constellation, int planes, int each) {
  std::vector<BroadcastOrbit> all;
  for (int i = 0; i < planes * each; ++i) {
    BroadcastOrbit orbit;
    orbit.satellite = {constellation, i + 1};
    orbit.reference = on_24_june(8, 0);
    orbit.clock_reference = orbit.reference;
    orbit.toe = 115200.0;
    orbit.root_axis = 5153.7;
    orbit.eccentricity = 0.001 * (i % 7);
    orbit.inclination = 0.96;
    orbit.node = 2.0 * kPi * (i % planes) / planes;
    orbit.mean_anomaly = 2.0 * kPi * (i / planes + 0.3 * (i % planes)) / each;
    orbit.clock_polynomial = {1e-5 * (i - 8), 1e-11 * (i % 5 - 2), 0.0};
    orbit.group_delay = 1e-9 * (i % 9 - 4);
    all.push_back(orbit);
  }
  return all;
}

/// From where a satellite stood when it sent what is heard at `time` to the antenna, in the antenna's east,
/// north and up of that moment [m]. Worked out in the frame in which the Earth stood still when the signal
/// left: the antenna goes on with the Earth while the signal flies straight.
inline Eigen::Vector3d way(const BroadcastOrbit& orbit, const LocalFrame& map, const GnssTime& time) {
  double flight = 0.07;
  Eigen::Vector3d seen = Eigen::Vector3d::Zero();
  for (int i = 0; i < 6; ++i) {
    const Eigen::AngleAxisd earth(kEarthRotationRate * flight, Eigen::Vector3d::UnitZ());
    seen = satellite_state(orbit, time + -flight).position - earth * map.origin();
    flight = seen.norm() / kSpeedOfLight;
  }
  const Eigen::AngleAxisd back(-kEarthRotationRate * flight, Eigen::Vector3d::UnitZ());
  return map.vector_to_map(back * seen);
}

/// What a receiver at `antenna` measures whose clock is `clock` [s] ahead and gains `drift` [1].
inline RawEpoch heard(const std::vector<BroadcastOrbit>& satellites, const Geodetic& antenna,
                      const GnssTime& time, double clock, double drift,
                      const std::optional<KlobucharCoefficients>& ionosphere) {
  const LocalFrame map(antenna);
  RawEpoch epoch;
  epoch.time = time + clock;
  for (const BroadcastOrbit& orbit : satellites) {
    const Eigen::Vector3d seen = way(orbit, map, time);
    const Direction direction = direction_of(seen);
    if (direction.elevation < 0.0) continue;
    const double flight = seen.norm() / kSpeedOfLight;
    const SatelliteState state = satellite_state(orbit, time + -flight);
    const double rate = way(orbit, map, time + 0.5).norm() - way(orbit, map, time + -0.5).norm() +
                        kSpeedOfLight * (drift - state.clock_drift);
    RawObservation raw;
    raw.satellite = orbit.satellite;
    raw.pseudorange = kSpeedOfLight * (flight + clock - state.clock + orbit.group_delay) +
                      saastamoinen_delay(antenna, direction.elevation);
    if (ionosphere) raw.pseudorange += klobuchar_delay(*ionosphere, antenna, direction, time);
    raw.doppler = -rate * 1575.42e6 / kSpeedOfLight;
    raw.cn0 = 45.0;
    epoch.observations.push_back(raw);
  }
  return epoch;
}

inline KlobucharCoefficients summer_ionosphere() {
  KlobucharCoefficients all;
  all.alpha << 1.8626e-08, 2.2352e-08, -1.1921e-07, -5.9605e-08;
  all.beta << 1.2902e+05, 1.6384e+05, -1.9661e+05, -2.6214e+05;
  return all;
}

inline Navigation navigation_of(const std::vector<BroadcastOrbit>& satellites) {
  Navigation navigation;
  for (const BroadcastOrbit& orbit : satellites) navigation.ephemerides.add(orbit);
  navigation.ionosphere = summer_ionosphere();
  return navigation;
}

}  // namespace multipath_localization
