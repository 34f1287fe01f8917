#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/time.h>

#include "multipath_localization/LocalizationState.h"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/trust.hpp"

namespace multipath_localization {

/// The time by the clock of messages, which may be simulated, and by one that always goes on.
struct Moment {
  ros::Time stamp;
  ros::SteadyTime steady;

  static Moment now() { return {ros::Time::now(), ros::SteadyTime::now()}; }
};

/// Where the robot was last, and whether to drive by it.
class PoseInput {
 public:
  /// Takes the pose that arrives at that time; what is not finite of it is so as a whole.
  void take(const nav_msgs::Odometry& message, const ros::SteadyTime& arrived);

  /// Takes a state, one that is not known as LOST. Returns whether the pose has become unknown by it: that
  /// counts at once, even if it is over before the next pose.
  bool take(const LocalizationState& message);

  [[nodiscard]] const Pose2& pose() const { return pose_; }  ///< of the base in map
  [[nodiscard]] double sigma() const { return sigma_; }      ///< of the position to a side [m]
  [[nodiscard]] Trust trust() const { return trust_; }
  /// Whether the localisation knows where the robot is.
  [[nodiscard]] bool known() const { return trust_ != Trust::kNotReady && trust_ != Trust::kLost; }
  /// By its stamp, or, where that is longer, since it arrived: a clock that stands still ages nothing [s].
  /// NaN without a pose.
  [[nodiscard]] double age(const Moment& now) const;

 private:
  Pose2 pose_;
  double sigma_ = 0.0;
  ros::Time stamp_;  ///< zero before the first pose
  ros::SteadyTime arrived_;
  Trust trust_ = Trust::kNotReady;
};

}  // namespace multipath_localization
