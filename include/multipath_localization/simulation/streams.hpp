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
  kDualReceiverStream,
  kZoneStream = 0xF0001000U,  ///< plus the index of the zone
  kConstellationStream = 0xF0002000U,
  kReceiverClockStream,
  kReceiverLatencyStream,
  kInterSystemStream,
  kSatelliteStream = 0xF0003000U,  ///< plus the index of the satellite
  kWallStream = 0xF0004000U,       ///< plus the index of the wall
};

}  // namespace multipath_localization
