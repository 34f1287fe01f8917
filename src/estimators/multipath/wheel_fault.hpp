#pragma once

#include "estimators/multipath/hypothesis.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization::multipath {

/// A fault drawn from what wheels do: a slip, a lock, an encoder that is dead.
WheelFault draw_wheel_fault(RandomStream& random);

/// Probability that a fault goes on for `duration` [s]; wheels that stand are locked for longer.
double fault_goes_on(double duration, bool standing);

/// Covariance of where the robot may have driven unseen by wheels that fail so, at `speed` [m/s] for
/// `duration` [s], by the heading of the hypothesis [m^2].
Eigen::Matrix2d unseen_motion(const Hypothesis& hypothesis, const WheelFault& fault, double speed,
                              double duration);

/// Turns a hypothesis as its wheel fault may have done in that time [s].
void turn_unseen(Hypothesis& hypothesis, double duration, RandomStream& random);

/// Moves a hypothesis whose wheels fail by `way` [m], unsure by a covariance of `unseen` [m^2], and turns it
/// as its fault may do in `turning` [s].
void fail(Hypothesis& hypothesis, const Eigen::Vector2d& way, const Eigen::Matrix2d& unseen, double turning,
          RandomStream& random);

/// Moves a hypothesis by its wheel fault, which may turn it too unless a gyro tells the turns.
void move_unseen(Hypothesis& hypothesis, double speed, double duration, bool turns_by_gyro,
                 RandomStream& random);

}  // namespace multipath_localization::multipath
