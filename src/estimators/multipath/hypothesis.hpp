#pragma once

#include <Eigen/Core>

#include "estimators/multipath/error_laws.hpp"
#include "estimators/multipath/heading_law.hpp"
#include "estimators/multipath/level_laws.hpp"
#include "estimators/multipath/odometry_sum.hpp"
#include "estimators/multipath/other_receivers.hpp"
#include "estimators/multipath/state.hpp"
#include "estimators/multipath/velocity_law.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization::multipath {

/// Wheels that turn otherwise than the robot drives; all zero while they do not.
struct WheelFault {
  double speed = 0.0;         ///< sigma of the unseen motion, in what the robot usually does
  double heading_rate = 0.0;  ///< sigma of the unseen turn in a second [rad/s]

  [[nodiscard]] bool any() const { return speed > 0.0; }
};

/// One Rao-Blackwellised particle: a Kalman filter for the state, and sampled what makes that one linear.
struct Hypothesis {
  State mean = State::Zero();
  StateCovariance covariance = StateCovariance::Zero();
  double log_weight = 0.0;
  ErrorLaw law;
  LevelLaws level_laws;
  double level = 0.0;  ///< declared sigma that the slow error refers to [m]
  bool in_shadow = false;
  ShadowLaw shadow_law;
  WheelFault wheel_fault;
  VelocityLaw velocity;
  HeadingLaw heading;
  OtherReceivers others;

  [[nodiscard]] Pose2 pose() const { return pose_of(mean); }
  /// What a fix is off by, its white noise apart [m].
  [[nodiscard]] Eigen::Vector2d bias() const { return mean.segment<2>(kSlowX) + mean.segment<2>(kShadowX); }
  [[nodiscard]] Eigen::Matrix2d bias_covariance() const;  ///< [m^2]

  /// Moves on by odometry, equation (4).
  void propagate(const OdometrySum& odometry, const OdometryNoise& noise);

  /// Forgets the heading: it is `yaw` [rad] with variance `variance`, correlated with nothing.
  void renew_heading(double yaw, double variance);

  /// The receiver goes on at another level, with a law of its own; the slow error stays as large until the
  /// next fix.
  void change_level(FixLevel from, FixLevel to, RandomStream& random);

  /// Takes over what another one holds of the errors of this receiver and this robot: law and constants of
  /// the odometry.
  void adopt(const Hypothesis& other);

  /// Puts the base where a fix says it is, give or take what the law says fixes are off by, equation (8).
  void place_at(const GnssFix& fix);

  /// Kalman correction by a fix with white noise of that covariance [m^2].
  void correct(const GnssFix& fix, const Eigen::Matrix2d& noise);
};

/// Scales two components of the state from `first` on by `keep` and adds a variance to each.
void decay(Hypothesis& hypothesis, StateIndex first, double keep, double variance);

/// Loses the position, of which the variance of an axis grows by that [m^2], and the heading, which is any or
/// unsure.
void lose(Hypothesis& hypothesis, double variance, RandomStream& random);

/// Kalman correction by one component of the state, measured with that variance.
void observe(Hypothesis& hypothesis, StateIndex index, double value, double variance);

/// Gives a hypothesis whose heading was any a heading [rad] of that variance [rad^2], and turns it about
/// where the antenna was at the start: the base is `from_start` from there, in its own frame [m].
void take_heading(Hypothesis& hypothesis, double yaw, double variance, const Eigen::Vector2d& from_start);

/// Holds the fixes right and the position wrong by the bias of the shadow, which is none then.
void move_by_bias(Hypothesis& hypothesis);

}  // namespace multipath_localization::multipath
