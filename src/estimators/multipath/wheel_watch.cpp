#include "estimators/multipath/wheel_watch.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kSpeedMemory = 10.0;     // over which the usual speed is averaged [s]
constexpr double kSuspicion = 1.5;        // a fault begins when odometry jumps, or does not [s]
constexpr double kFaultsToBrakes = 0.03;  // hard brakes look alike where no fix tells them from faults
constexpr double kTelling = 3.0;          // fixes further apart do not acquit [s]

}  // namespace

void WheelWatch::add(const OdometryIncrement& u) {
  jump_.add(u);
  moving_time_ += moving_.add(u);
  if (!multipath_localization::standing(u)) way_ += ground_speed(u) * u.duration;
}

/// Of so many jumps without a fault the next one is one with the probability of Laplace's rule.
double WheelWatch::chance(const OdometryJump::Jump& jump) const {
  return fault_probability_ / (1.0 + (jump.turn ? innocent_.turns : innocent_.speeds));
}

double WheelWatch::take_suspicion() {
  const OdometryJump::Jump jump = jump_.take();
  if (!jump.any()) return 0.0;
  suspected_for_ = kSuspicion;
  suspect_ = {suspect_.speed || jump.speed, suspect_.turn || jump.turn};
  return jump.turn ? chance(jump) : kFaultsToBrakes * chance(jump);
}

/// Once the time of a suspicion is over.
void WheelWatch::acquit(double duration, double fault) {
  const bool innocent = duration <= kTelling && fault < 0.5;
  if (innocent && suspect_.speed) ++innocent_.speeds;
  if (innocent && suspect_.turn) ++innocent_.turns;
  suspect_ = {};
}

void WheelWatch::look_back(double duration, double fault) {
  if (!standing(duration)) {
    usual_speed_ += std::min(1.0, duration / kSpeedMemory) * (way_ / duration - usual_speed_);
  }
  speed_ = way_ / duration;
  suspected_for_ = std::max(0.0, suspected_for_ - duration);
  if (suspected_for_ <= 0.0) acquit(duration, fault);
  take_suspicion();
  moving_time_ = way_ = 0.0;
}

double WheelWatch::fault_probability(double duration) const {
  return suspected_for_ > 0.0 ? chance(suspect_) * duration / (1.0 + duration) : 0.0;
}

}  // namespace multipath_localization::multipath
