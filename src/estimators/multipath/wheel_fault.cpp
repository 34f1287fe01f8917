#include "estimators/multipath/wheel_fault.hpp"

#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kSlipTime = 3.0;   // wheels that spin or skip [s]
constexpr double kLockTime = 10.0;  // wheels that stand: a brake, a dead driver [s]
// Unseen motion: from a tenth of what the robot does to twice that; turns up to what one dead wheel feigns.
constexpr double kLeastSpeed = 0.1;
constexpr double kLargestSpeed = 2.0;
constexpr double kLeastTurn = 0.03;   // [rad/s]
constexpr double kLargestTurn = 3.0;  // [rad/s]
constexpr double kAcross = 0.25;      // of the variance along: wheels slide ahead rather than aside
constexpr double kLinearTurn = 0.3;   // of the turn, held by the Kalman filter; the rest is drawn

}  // namespace

WheelFault draw_wheel_fault(RandomStream& random) {
  const double speed = log_uniform(kLeastSpeed, kLargestSpeed, random);
  return {speed, log_uniform(kLeastTurn, kLargestTurn, random)};
}

double fault_goes_on(double duration, bool standing) {
  return std::exp(-duration / (standing ? kLockTime : kSlipTime));
}

Eigen::Matrix2d unseen_motion(const Hypothesis& hypothesis, const WheelFault& fault, double speed,
                              double duration) {
  const Eigen::Vector2d ahead = rotation(hypothesis.mean(kYaw)).col(0);
  return square(fault.speed * speed * duration) *
         (kAcross * Eigen::Matrix2d::Identity() + (1.0 - kAcross) * ahead * ahead.transpose());
}

void fail(Hypothesis& h, const Eigen::Vector2d& way, const Eigen::Matrix2d& unseen, double turning,
          RandomStream& random) {
  h.mean.head<2>() += way;
  h.covariance.topLeftCorner<2, 2>() += unseen;
  if (turning > 0.0) turn_unseen(h, turning, random);
}

void move_unseen(Hypothesis& h, double speed, double duration, bool turns_by_gyro, RandomStream& random) {
  h.covariance.topLeftCorner<2, 2>() += unseen_motion(h, h.wheel_fault, speed, duration);
  if (!turns_by_gyro) turn_unseen(h, duration, random);
}

void turn_unseen(Hypothesis& h, double duration, RandomStream& random) {
  const double turn = h.wheel_fault.heading_rate * duration;
  h.mean(kYaw) = wrap_angle(h.mean(kYaw) + turn * random.normal());
  h.covariance(kYaw, kYaw) += square(kLinearTurn * turn);
}

}  // namespace multipath_localization::multipath
