#include "estimators/multipath/wheel_watch.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/models/odometry_motion.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kSpeedMemory = 10.0;     // over which the usual speed is averaged [s]
constexpr double kSuspicion = 1.5;        // a fault begins when odometry jumps, or does not [s]
constexpr double kFaultsToBrakes = 0.03;  // hard brakes look alike where no fix tells them from faults

}  // namespace

void WheelWatch::add(const OdometryIncrement& u) {
  jump_.add(u);
  if (multipath_localization::standing(u)) return;
  moving_time_ += u.duration;
  way_ += ground_speed(u) * u.duration;
}

double WheelWatch::take_suspicion() {
  const OdometryJump::Jump jump = jump_.take();
  if (!jump.any()) return 0.0;
  suspected_for_ = kSuspicion;
  return jump.turn ? fault_probability_ : kFaultsToBrakes * fault_probability_;
}

void WheelWatch::look_back(double duration) {
  if (!standing(duration)) {
    usual_speed_ += std::min(1.0, duration / kSpeedMemory) * (way_ / duration - usual_speed_);
  }
  speed_ = way_ / duration;
  suspected_for_ = std::max(0.0, suspected_for_ - duration);
  take_suspicion();
  moving_time_ = way_ = 0.0;
}

double WheelWatch::fault_probability(double duration) const {
  return suspected_for_ > 0.0 ? fault_probability_ * duration / (1.0 + duration) : 0.0;
}

}  // namespace multipath_localization::multipath
