#pragma once

#include <nav_msgs/Odometry.h>

#include "multipath_localization/LocalizationState.h"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/trust.hpp"
#include "ros/steering_node/moment.hpp"

namespace multipath_localization {

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
  [[nodiscard]] double age(const Moment& now) const { return arrival_.age(now); }  ///< NaN without one [s]

 private:
  Pose2 pose_;
  double sigma_ = 0.0;
  Arrival arrival_;
  Trust trust_ = Trust::kNotReady;
};

}  // namespace multipath_localization
