#include "multipath_localization/guidance/caution.hpp"

#include <algorithm>
#include <cmath>

#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

std::string old_pose(double age) {
  if (!std::isfinite(age)) return "no pose yet";
  return "pose is " + fixed_text(std::abs(age), 1) + (age > 0.0 ? " s old" : " s ahead");
}

/// Why the robot slows that does, by what is known of the pose.
std::string reason_to_slow(Trust state) {
  switch (state) {
    case Trust::kAligning: return "heading not yet confirmed";
    case Trust::kMultipath: return "fixes are biased";
    case Trust::kDeadReckoning: return "no usable fix";
    default: return "position uncertain";
  }
}

}  // namespace

bool Caution::heed(Trust state) {
  if (state != Trust::kNotReady && state != Trust::kLost) return false;
  underway_ = false;
  first_position_.reset();
  return true;
}

std::string Caution::reason_to_stop(const KnownPose& known) const {
  if (!(std::abs(known.age) <= parameters_.max_pose_age)) return old_pose(known.age);
  if (!known.pose.finite() || !std::isfinite(known.sigma)) return "pose not finite";
  if (known.trust == Trust::kNotReady) return "localisation not ready";
  if (known.trust == Trust::kLost) return "localisation lost";
  return "";
}

double Caution::ratio_by(double sigma) const {
  const double range = parameters_.stop_sigma - parameters_.slow_sigma;
  const double left = parameters_.stop_sigma - sigma;
  if (sigma > parameters_.slow_sigma && range > 0.0) return std::clamp(left / range, 0.0, 1.0);
  return left > 0.0 ? 1.0 : 0.0;
}

Pace Caution::pace(const KnownPose& known) const {
  const std::string reason = reason_to_stop(known);
  if (!reason.empty()) return {0.0, "stopped: " + reason, true};
  const double ratio =
      known.trust == Trust::kAligning ? parameters_.aligning_speed_ratio : ratio_by(known.sigma);
  if (ratio == 1.0) return {1.0, "driving", false};
  return {ratio, (ratio > 0.0 ? "slow: " : "stopped: ") + reason_to_slow(known.trust), false};
}

bool Caution::heading_shown(const KnownPose& known) {
  const Eigen::Vector2d position = known.pose.position();
  if (!first_position_) first_position_ = position;
  const bool far_enough = (position - *first_position_).norm() >= parameters_.aligning_distance;
  underway_ = underway_ || known.trust != Trust::kAligning || far_enough;
  return underway_;
}

}  // namespace multipath_localization
