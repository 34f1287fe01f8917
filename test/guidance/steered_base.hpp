#pragma once

#include <algorithm>
#include <cmath>
#include <deque>

#include "driven.hpp"
#include "multipath_localization/guidance/command_limiter.hpp"

namespace multipath_localization {

/// What a base makes of its commands, and when its poses arrive.
struct BaseTraits {
  double wheelbase = 0.5;
  double steering_lag = 0.0;  ///< time constant of the front wheel [s]
  double pose_age = 0.0;      ///< [s]
};

/// A front-wheel-steering base that obeys commands after a lag, and whose poses arrive late.
class SteeredBase {
 public:
  SteeredBase(const BaseTraits& traits, const Pose2& pose) : traits_(traits), poses_({pose}) {}

  void step(const MotionCommand& command, double duration) {
    const double share = traits_.steering_lag > 0.0 ? -std::expm1(-duration / traits_.steering_lag) : 1.0;
    angle_ += share * (command.steering_angle - angle_);
    poses_.push_back(driven(poses_.back(), {command.speed, angle_}, traits_.wheelbase, duration));
    while (static_cast<double>(poses_.size() - 1) * duration > traits_.pose_age + 0.5 * duration)
      poses_.pop_front();
  }

  [[nodiscard]] const Pose2& pose() const { return poses_.back(); }
  [[nodiscard]] const Pose2& arrived() const { return poses_.front(); }  ///< pose_age old

 private:
  BaseTraits traits_;
  double angle_ = 0.0;
  std::deque<Pose2> poses_;
};

}  // namespace multipath_localization
