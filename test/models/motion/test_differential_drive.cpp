#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/models/motion/differential_drive.hpp"

namespace multipath_localization {
namespace {

constexpr double kSeparation = 0.35;  // B of Table 1 of [KAM]

TEST(WheelSpeeds, OfTable1DriveItsCircle) {
  const WheelSpeeds wheels{0.2, 0.3};
  EXPECT_NEAR(speed(wheels), 0.25, 1e-15);
  EXPECT_NEAR(yaw_rate(wheels, kSeparation), 0.1 / 0.35, 1e-15);
  EXPECT_NEAR(speed(wheels) / yaw_rate(wheels, kSeparation), 0.5 * kSeparation * 0.5 / 0.1, 1e-12);  // radius
}

TEST(WheelSpeeds, FollowFromSpeedAndYawRateAndLeadBack) {
  for (const double v : {-1.0, 0.0, 0.25}) {
    for (const double omega : {-2.0, 0.0, 0.3}) {
      const WheelSpeeds wheels = wheel_speeds(v, omega, kSeparation);
      EXPECT_NEAR(speed(wheels), v, 1e-15);
      EXPECT_NEAR(yaw_rate(wheels, kSeparation), omega, 1e-14);
    }
  }
  EXPECT_GT(wheel_speeds(0.0, 1.0, kSeparation).right, 0.0) << "counter-clockwise";
}

Eigen::Vector3d end_of(const Pose2& start, const WheelSpeeds& wheels, double duration) {
  const Pose2 end = start * displacement({0.0, duration, speed(wheels), yaw_rate(wheels, kSeparation)});
  return {end.x, end.y, end.yaw};
}

TEST(WheelJacobian, IsThatOfTheMotion) {
  constexpr double kStep = 1e-6;
  for (const double heading : {-2.5, 0.0, 1.0}) {
    for (const double duration : {0.01, 0.4}) {
      for (const WheelSpeeds& wheels : {WheelSpeeds{0.2, 0.3}, WheelSpeeds{0.4, 0.4}, WheelSpeeds{-0.1, 0.1},
                                        WheelSpeeds{0.0, 0.0}, WheelSpeeds{-0.5, -0.2}}) {
        const Pose2 start{1.0, -2.0, heading};
        const OdometryIncrement u{0.0, duration, speed(wheels), yaw_rate(wheels, kSeparation)};
        Eigen::Matrix<double, 3, 2> central;
        central.col(0) = end_of(start, {wheels.left + kStep, wheels.right}, duration) -
                         end_of(start, {wheels.left - kStep, wheels.right}, duration);
        central.col(1) = end_of(start, {wheels.left, wheels.right + kStep}, duration) -
                         end_of(start, {wheels.left, wheels.right - kStep}, duration);
        central /= 2.0 * kStep;
        EXPECT_LT((wheel_jacobian(start, u, kSeparation) - central).cwiseAbs().maxCoeff(), 1e-8);
      }
    }
  }
}

TEST(WheelJacobian, StraightAheadMovesThePositionAsPrinted) {  // B of Eq. (3) of [KAM]
  const double dt = 0.01;
  const double theta = 0.7;
  const auto G = wheel_jacobian({0.0, 0.0, theta}, {0.0, dt, 0.25, 0.0}, kSeparation);
  const Eigen::Vector2d by_speed = G.topRows<2>() * Eigen::Vector2d(1.0, 1.0);
  EXPECT_NEAR(by_speed.x(), dt * std::cos(theta), 1e-15);
  EXPECT_NEAR(by_speed.y(), dt * std::sin(theta), 1e-15);
}

}  // namespace
}  // namespace multipath_localization
