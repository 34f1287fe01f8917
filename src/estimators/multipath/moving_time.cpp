#include "estimators/multipath/moving_time.hpp"

#include <utility>

#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization::multipath {

namespace {

/// Ticks further apart are those of wheels that stand: a mower that creeps at 5 cm/s tells of 15 mm at once
/// [s].
constexpr double kTickGap = 0.3;

}  // namespace

double MovingTime::add(const OdometryIncrement& u) {
  since_moving_ += u.duration;
  if (standing(u)) return 0.0;
  const double time = std::exchange(since_moving_, 0.0);
  return time <= kTickGap ? time : u.duration;
}

}  // namespace multipath_localization::multipath
