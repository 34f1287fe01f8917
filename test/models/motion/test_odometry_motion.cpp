#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization {
namespace {

OdometryIncrement increment(double duration, double speed, double yaw_rate, double lateral_speed) {
  return {duration, duration, speed, yaw_rate, lateral_speed};
}

TEST(MotionJacobians, EqualCentralDifferences) {
  constexpr double kStep = 1e-6;
  for (const double yaw_rate : {-1.5, 0.0, 1e-5, 0.4}) {
    for (const auto& [speed, lateral_speed] : {std::pair(-2.0, 0.0), {0.0, 0.7}, {0.0, 0.0}, {5.0, -1.2}}) {
      const Pose2 pose{1.0, 2.0, 2.5};
      const OdometerErrors errors{0.03, 0.01};
      const OdometryIncrement u = increment(0.4, speed, yaw_rate, lateral_speed);
      const MotionJacobians analytic = motion_jacobians(pose, u, errors);
      const auto derivative = [&](const auto& vary) -> Eigen::Vector3d {
        const Pose2 ahead = vary(kStep);
        const Pose2 behind = vary(-kStep);
        return Eigen::Vector3d(ahead.x - behind.x, ahead.y - behind.y,
                               angle_difference(ahead.yaw, behind.yaw)) /
               (2.0 * kStep);
      };
      const auto near = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return (a - b).norm() < 1e-8;
      };
      EXPECT_TRUE(near(analytic.pose.col(0), derivative([&](double h) {
                         return moved({pose.x + h, pose.y, pose.yaw}, u, errors);
                       })));
      EXPECT_TRUE(near(analytic.pose.col(1), derivative([&](double h) {
                         return moved({pose.x, pose.y + h, pose.yaw}, u, errors);
                       })));
      EXPECT_TRUE(near(analytic.pose.col(2), derivative([&](double h) {
                         return moved({pose.x, pose.y, pose.yaw + h}, u, errors);
                       })));
      EXPECT_TRUE(near(analytic.errors.col(0), derivative([&](double h) {
                         return moved(pose, u, {errors.speed_scale + h, errors.gyro_bias});
                       })));
      EXPECT_TRUE(near(analytic.errors.col(1), derivative([&](double h) {
                         return moved(pose, u, {errors.speed_scale, errors.gyro_bias + h});
                       })));
    }
  }
}

TEST(Standing, NeitherRollsNorStrafesNorTurns) {
  EXPECT_TRUE(standing({1.0, 1.0, 0.004, 0.0, -0.004}));
  EXPECT_FALSE(standing({1.0, 1.0, 0.0, 0.0, -0.3}));
  EXPECT_FALSE(standing({1.0, 1.0, 0.0, 0.1}));
}

TEST(WithoutErrors, TheScaleIsThatOfAllWheels) {
  const OdometryIncrement u = without_errors({1.0, 1.0, 2.0, 0.3, -1.0}, {0.25, 0.1});
  EXPECT_DOUBLE_EQ(u.speed, 1.6);
  EXPECT_DOUBLE_EQ(u.lateral_speed, -0.8);
  EXPECT_DOUBLE_EQ(u.yaw_rate, 0.2);
}

}  // namespace
}  // namespace multipath_localization
