#pragma once

#include <ros/time.h>

#include <cmath>
#include <limits>

namespace multipath_localization {

/// The time by the clock of messages, which may be simulated, and by one that always goes on.
struct Moment {
  ros::Time stamp;
  ros::SteadyTime steady;

  static Moment now() { return {ros::Time::now(), ros::SteadyTime::now()}; }
};

/// When a message was measured, and when it arrived.
struct Arrival {
  ros::Time stamp;  ///< zero before the first message
  ros::SteadyTime arrived;

  /// By its stamp, or, where that is longer, since it arrived: a clock that stands still ages nothing [s].
  /// NaN without a message.
  [[nodiscard]] double age(const Moment& now) const {
    if (stamp.isZero()) return std::numeric_limits<double>::quiet_NaN();
    const double age = now.stamp.toSec() - stamp.toSec();  // a ros::Duration throws beyond 68 years
    const double silence = (now.steady - arrived).toSec();
    return silence > std::abs(age) ? silence : age;
  }
};

}  // namespace multipath_localization
