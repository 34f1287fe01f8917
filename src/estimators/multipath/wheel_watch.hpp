#pragma once

#include <algorithm>

#include "estimators/multipath/moving_time.hpp"
#include "estimators/multipath/odometry_jump.hpp"

namespace multipath_localization::multipath {

/// Tells when wheels may turn otherwise than the robot drives, and how fast it drives as a rule.
///
/// Odometry that changes faster than a robot can makes it probable that a fault of the wheels begins; the
/// less so, the more such jumps fixes have shown to be nothing but this robot's way to brake or turn.
class WheelWatch {
 public:
  WheelWatch(const OdometryJumpParameters& parameters, const OdometryNoise& noise)
      : jump_(parameters, noise), fault_probability_(parameters.fault_probability) {}

  /// Takes a usable increment.
  void add(const OdometryIncrement& u);

  /// Looks back on the time since the last call, `duration` [s], at the end of which the wheels are held to
  /// fail with probability `fault`.
  void look_back(double duration, double fault);

  /// Probability that a fault has begun since the last call, where no fix tells it from a hard brake.
  double take_suspicion();

  /// Of the last seconds in which the wheels turned, or what they say now where that is more [m/s].
  [[nodiscard]] double usual_speed() const { return std::max(usual_speed_, speed_); }
  /// Since the last `look_back`, whatever the direction [m].
  [[nodiscard]] double way() const { return way_; }
  /// That a fault begins within `duration` [s].
  [[nodiscard]] double fault_probability(double duration) const;
  /// Whether the wheels stood for most of the time since the last `look_back`.
  [[nodiscard]] bool standing(double duration) const { return moving_time_ < 0.5 * duration; }

 private:
  /// How many jumps of each kind were none of the wheels' fault.
  struct Innocent {
    int speeds = 0;
    int turns = 0;
  };

  [[nodiscard]] double chance(const OdometryJump::Jump& jump) const;
  void acquit(double duration, double fault);

  OdometryJump jump_;
  double fault_probability_;
  double usual_speed_ = 0.0;
  double speed_ = 0.0;          ///< before the last look [m/s]
  OdometryJump::Jump suspect_;  ///< what has jumped
  double suspected_for_ = 0.0;  ///< time that is left of that [s]
  Innocent innocent_;
  MovingTime moving_;
  double moving_time_ = 0.0;  ///< since the last look [s]
  double way_ = 0.0;          ///< since the last look [m]
};

}  // namespace multipath_localization::multipath
