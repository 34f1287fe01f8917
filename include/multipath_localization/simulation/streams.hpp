#pragma once

#include <cstdint>

namespace multipath_localization {

/// Whose random numbers a draw is for: the `particle` of RandomStream. Counted from far above any particle
/// cloud, so that a filter with the same seed draws nothing that the world drew.
enum SimulationStream : std::uint32_t {
  kRobotStream = 0xF0000000U,
  kOdometerStream,
  kOdometerNoiseStream,
  kReceiverStream,
  kReceiverNoiseStream,
  kZoneStream = 0xF0001000U,  ///< plus the index of the zone
};

}  // namespace multipath_localization
