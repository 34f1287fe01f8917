#include "ros/localization_node/backlog.hpp"

#include <cmath>
#include <utility>

namespace multipath_localization {

namespace {

constexpr double kSameInstant = 1e-6;  ///< [s]

}  // namespace

bool Backlog::take(ros::WallTime now) {
  if (!begun_) begun_ = now;
  return (now - *begun_).toSec() > max_lag_;
}

Backlog::LeftOut Backlog::take_left_out() { return std::exchange(left_out_, {}); }

std::optional<OdometryIncrement> HeldOdometry::add(const OdometryIncrement& increment) {
  const bool follows = held_ && std::abs(increment.stamp - increment.duration - held_->stamp) < kSameInstant;
  if (follows) {
    held_ = joined(*held_, increment);
    return {};
  }
  return std::exchange(held_, increment);
}

std::optional<OdometryIncrement> HeldOdometry::take() { return std::exchange(held_, std::nullopt); }

}  // namespace multipath_localization
