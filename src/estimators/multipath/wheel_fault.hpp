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

/// Moves a hypothesis by its wheel fault, which may turn it too unless a gyro tells the turns.
void move_unseen(Hypothesis& hypothesis, double speed, double duration, bool turns_by_gyro,
                 RandomStream& random);

}  // namespace multipath_localization::multipath
