#include "multipath_localization/models/standstill.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/models/odometry_motion.hpp"

namespace multipath_localization {

namespace {

constexpr double kAboveNoise = 0.1;  ///< no gyro says so much without turning [rad/s]
constexpr double kAboveBias = 0.02;  ///< nor on average [rad/s]
constexpr double kMemory = 0.5;      ///< of the average [s]

}  // namespace

OdometryIncrement Standstill::settled(const OdometryIncrement& u) {
  yaw_rate_ += std::min(1.0, u.duration / kMemory) * (u.yaw_rate - yaw_rate_);
  OdometryIncrement result = u;
  const bool turning = std::abs(u.yaw_rate) > kAboveNoise || std::abs(yaw_rate_) > kAboveBias;
  if (std::abs(u.speed) < kStandstillSpeed && !turning) result.yaw_rate = 0.0;
  return result;
}

std::vector<OdometryIncrement> settled(const std::vector<OdometryIncrement>& drive) {
  Standstill standstill;
  std::vector<OdometryIncrement> result;
  result.reserve(drive.size());
  for (const OdometryIncrement& u : drive) result.push_back(standstill.settled(u));
  return result;
}

}  // namespace multipath_localization
