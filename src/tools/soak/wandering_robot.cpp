#include "tools/soak/wandering_robot.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

namespace {

constexpr double kRoamsWithin = 300.0;  ///< of home [m]
constexpr double kAcceleration = 1.0;   ///< [m/s^2]
constexpr double kSpeed = 2.0;          ///< forwards, at most [m/s]
constexpr double kBackwards = 0.7;      ///< [m/s]
constexpr double kYawRate = 0.4;        ///< at most [rad/s]
constexpr double kLeg = 40.0;           ///< at most [s]
constexpr double kStand = 300.0;        ///< at most [s]

}  // namespace

OdometryIncrement WanderingRobot::step(double duration) {
  if (left_ <= 0.0) begin_leg();
  left_ -= duration;
  time_ += duration;
  const double change = kAcceleration * duration;
  const double wanted = left_ > 0.0 ? target_speed_ : 0.0;
  speed_ += std::clamp(wanted - speed_, -change, change);
  const OdometryIncrement u{time_, duration, speed_, yaw_rate_};
  pose_ = pose_ * displacement(u);
  return u;
}

void WanderingRobot::begin_leg() {
  RandomStream random(seed_, legs_++, 0);
  const double kind = random.uniform();
  left_ = kLeg * random.uniform();
  target_speed_ = kSpeed * random.uniform();
  yaw_rate_ = kYawRate * (2.0 * random.uniform() - 1.0);
  if (kind < 0.1) target_speed_ = -kBackwards;
  if (kind > 0.95) {
    target_speed_ = yaw_rate_ = 0.0;
    left_ = kStand * random.uniform();
  }
  if (pose_.position().norm() < kRoamsWithin) return;
  const double homewards = angle_difference(std::atan2(-pose_.y, -pose_.x), pose_.yaw);
  target_speed_ = kSpeed;
  left_ = 1.0 + std::abs(homewards) / kYawRate;
  yaw_rate_ = homewards / left_;
}

}  // namespace multipath_localization
