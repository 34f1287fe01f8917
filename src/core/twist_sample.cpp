#include "multipath_localization/core/twist_sample.hpp"

namespace multipath_localization {

OdometryIncrement motion_between(const TwistSample& before, const TwistSample& now) {
  return {now.stamp, now.stamp - before.stamp, 0.5 * (before.speed + now.speed),
          0.5 * (before.yaw_rate + now.yaw_rate), 0.5 * (before.lateral_speed + now.lateral_speed)};
}

OdometryIncrement motion_of(const TwistSample& sample, double duration) {
  return {sample.stamp, duration, sample.speed, sample.yaw_rate, sample.lateral_speed};
}

}  // namespace multipath_localization
