#include "ros/inputs/pose_agreement.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kMemory = 2.0;     // [s]
constexpr double kLeastTime = 1.0;  // before anything is said [s]
constexpr double kTolerance = 0.1;  // of way and turn
constexpr double kSlack = 0.03;     // beside that [m], [rad]
constexpr double kJump = 0.1;       // of one interval, beyond as much again as the twist says [m], [rad]

}  // namespace

bool PoseAgreement::agrees(const OdometryIncrement& by_pose, const OdometryIncrement& by_twist) {
  const double dt = by_pose.duration;
  const Eigen::Vector2d apart(by_pose.speed - by_twist.speed, by_pose.lateral_speed - by_twist.lateral_speed);
  const double turn_apart = by_pose.yaw_rate - by_twist.yaw_rate;
  const bool jumps = apart.norm() * dt > kJump + ground_speed(by_twist) * dt ||
                     std::abs(turn_apart) * dt > kJump + std::abs(by_twist.yaw_rate) * dt;
  if (jumps) {
    clear();
    return false;
  }
  const double kept = std::exp(-dt / kMemory);
  way_apart_ = kept * way_apart_ + dt * apart;
  turn_apart_ = kept * turn_apart_ + dt * turn_apart;
  way_ = kept * way_ + dt * ground_speed(by_twist);
  turn_ = kept * turn_ + dt * std::abs(by_twist.yaw_rate);
  time_ += dt;
  return time_ >= kLeastTime && way_apart_.norm() <= kSlack + kTolerance * way_ &&
         std::abs(turn_apart_) <= kSlack + kTolerance * turn_;
}

}  // namespace multipath_localization
