#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "simulation/raw_receiver.hpp"

namespace multipath_localization {

inline const LocalFrame kMap({35.0, 139.0, 40.0});
inline const AntennaState kAtRest{{50.0, -20.0, 2.0}, Eigen::Vector3d::Zero()};

/// A receiver without any error but its clock's.
inline RawReceiverParameters exact() {
  RawReceiverParameters parameters;
  parameters.fading_sigma = parameters.code_noise = parameters.doppler_noise = 0.0;
  parameters.atmosphere_sigma = parameters.inter_system_sigma = 0.0;
  parameters.lock_delay = 0.0;
  return parameters;
}

inline RawReceiver receiver(const RawReceiverParameters& parameters, std::uint64_t seed = 1,
                            const std::vector<BuildingParameters>& buildings = {}) {
  SkyParameters sky;
  sky.reflection_loss_spread_db = 0.0;
  return {parameters, satellites({}, seed), SkyView(sky, buildings, seed), kMap, seed};
}

inline int key(const SatelliteObservation& observation) {
  return 100 * static_cast<int>(observation.constellation) + observation.satellite;
}

inline std::map<int, TrackedSignal> by_satellite(const std::vector<TrackedSignal>& signals) {
  std::map<int, TrackedSignal> all;
  for (const TrackedSignal& signal : signals) all[key(signal.observation)] = signal;
  return all;
}

}  // namespace multipath_localization
