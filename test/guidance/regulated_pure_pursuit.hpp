#pragma once

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/guidance/path.hpp"

namespace multipath_localization {

/// Regulated pure pursuit (Macenski et al. 2023) as Nav2 has it by default, for comparison: look-ahead by
/// speed, slower in bends of less than 0.9 m, and on the last 0.6 m.
class RegulatedPurePursuit {
 public:
  RegulatedPurePursuit(const Path& path, double cruise_speed, double wheelbase)
      : path_(path), cruise_speed_(cruise_speed), wheelbase_(wheelbase) {}

  MotionCommand command(const Pose2& pose, double speed) {
    station_ = path_.nearest(pose.position(), station_ - 1.0, station_ + 1.0);
    const double lookahead = std::clamp(1.5 * speed, 0.3, std::max(0.9, 1.5 * cruise_speed_));
    const double left = path_.length() - station_;
    const Eigen::Vector2d carrot =
        inverse(pose) * path_.at(std::min(station_ + lookahead, path_.length())).position;
    const double curvature = 2.0 * carrot.y() / std::max(carrot.squaredNorm(), 1e-4);
    const double regulated = std::min(1.0, 1.0 / std::max(0.9 * std::abs(curvature), 1e-6));
    const double approach = std::min(1.0, left / 0.6);
    return {std::max(0.05, cruise_speed_ * std::min(regulated, approach)), std::atan(wheelbase_ * curvature)};
  }

  [[nodiscard]] double station() const { return station_; }

 private:
  const Path& path_;
  double cruise_speed_;
  double wheelbase_;
  double station_ = 0.0;
};

}  // namespace multipath_localization
