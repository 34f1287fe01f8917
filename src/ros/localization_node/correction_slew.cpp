#include "ros/localization_node/correction_slew.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

/// How much of a way may be gone at that rate.
double share(double way, double rate, double duration) {
  return rate > 0.0 && way > rate * duration ? rate * duration / way : 1.0;
}

}  // namespace

void SlewParameters::fields(ParameterVisitor& field) {
  field("max_correction_rate", max_correction_rate, {0.0, 100.0}, "m/s",
        "map -> odom moves the robot no faster than this, 0: at once; poses on topics jump as they do");
  field("max_correction_turn_rate", max_correction_turn_rate, {0.0, 10.0}, "rad/s",
        "nor turns it faster than this, 0: at once");
}

Pose2 CorrectionSlew::follow(const Pose2& odom_in_map, const Pose2& base_in_odom, double stamp) {
  const double duration = std::max(0.0, stamp - std::exchange(stamp_, stamp));
  if (!shown_) return *(shown_ = odom_in_map);
  const Pose2 from = *shown_ * base_in_odom;
  const Pose2 to = odom_in_map * base_in_odom;
  const Eigen::Vector2d way = to.position() - from.position();
  const double turn = angle_difference(to.yaw, from.yaw);
  const double moved = share(way.norm(), parameters_.max_correction_rate, duration);
  const double turned = share(std::abs(turn), parameters_.max_correction_turn_rate, duration);
  if (moved == 1.0 && turned == 1.0) return *(shown_ = odom_in_map);
  const Eigen::Vector2d position = from.position() + moved * way;
  const Pose2 base{position.x(), position.y(), wrap_angle(from.yaw + turned * turn)};
  return *(shown_ = base * inverse(base_in_odom));
}

}  // namespace multipath_localization
