#pragma once

#include <cstdint>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// A robot that drives legs of random speed and turn, now and then backwards, and now and then stands for
/// minutes. It turns home where it gets too far.
class WanderingRobot {
 public:
  explicit WanderingRobot(std::uint64_t seed) : seed_(seed) {}

  /// Drives on for `duration` [s]; what it did.
  OdometryIncrement step(double duration);
  /// The base in map.
  [[nodiscard]] const Pose2& pose() const { return pose_; }

 private:
  void begin_leg();

  std::uint64_t seed_;
  std::uint32_t legs_ = 0;
  double left_ = 0.0;          ///< of the leg [s]
  double time_ = 0.0;          ///< since the start [s]
  double speed_ = 0.0;         ///< [m/s]
  double target_speed_ = 0.0;  ///< it speeds up or slows down to [m/s]
  double yaw_rate_ = 0.0;      ///< [rad/s]
  Pose2 pose_;
};

}  // namespace multipath_localization
