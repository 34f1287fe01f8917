#include "multipath_localization/localization/standstill.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization {

namespace {

constexpr double kAboveNoise = 0.1;       ///< no gyro says so much without turning [rad/s]
constexpr double kAboveBias = 0.02;       ///< nor on average [rad/s]
constexpr double kStrafing = 0.1;         ///< no odometry says so much without strafing [m/s]
constexpr double kStrafingOnMean = 0.02;  ///< nor on average [m/s]
constexpr double kMemory = 0.5;           ///< of the averages [s]

}  // namespace

OdometryIncrement Standstill::settled(const OdometryIncrement& u) {
  const double share = std::min(1.0, u.duration / kMemory);
  speed_ += share * (u.speed - speed_);
  yaw_rate_ += share * (u.yaw_rate - yaw_rate_);
  lateral_speed_ += share * (u.lateral_speed - lateral_speed_);
  OdometryIncrement result = u;
  const bool turning = std::abs(u.yaw_rate) > kAboveNoise || std::abs(yaw_rate_) > kAboveBias;
  const bool strafing = std::abs(u.lateral_speed) > kStrafing || std::abs(lateral_speed_) > kStrafingOnMean;
  const bool rolling = std::abs(u.speed) >= kStandstillSpeed || std::abs(speed_) >= kStandstillSpeed;
  at_rest_ = !rolling && !turning && !strafing;
  if (at_rest_) result.yaw_rate = result.lateral_speed = 0.0;
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
