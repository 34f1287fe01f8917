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
  kGyroStream,
  kVelocityStream,
  kLaserStream,
  kCompassStream,
  kZoneStream = 0xF0001000U,       ///< plus the index of the zone
  kFaultZoneStream = 0xF0001800U,  ///< plus the index of the zone among the faults
  kConstellationStream = 0xF0002000U,
  kReceiverClockStream,
  kReceiverLatencyStream,
  kInterSystemStream,
  kSatelliteStream = 0xF0003000U,  ///< plus the index of the satellite
  kWallStream = 0xF0004000U,       ///< plus the index of the wall
  kFixLossStream = 0xF0005000U,
  kFixDuplicateStream,
  kFixSwapStream,
  kFixSpikeStream,
  kFixDelayStream,
  kOdometryLossStream,
  kGyroFaultStream,
  kVelocityFaultStream,
  kHeadingFaultStream,
  kFixColouredNoiseStream = 0xF0006000U,  ///< plus the index of the noise
  kFixWhiteNoiseStream = 0xF0007000U,     ///< plus the index of the noise
  kRandomRobotStream = 0xF0008000U,       ///< what a random robot is
  kRandomWayStream,
  kRandomOdometryStream,
  kRandomReceiverStream,
  kRandomFixStream,
  kRandomGyroStream,
  kRandomVelocityStream,
  kRandomHeadingStream,
};

}  // namespace multipath_localization
