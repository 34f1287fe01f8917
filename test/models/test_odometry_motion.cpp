#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/odometry_motion.hpp"

namespace multipath_localization {
namespace {

OdometryIncrement increment(double duration, double speed, double yaw_rate) {
  return {duration, duration, speed, yaw_rate};
}

TEST(SteeringMotion, SteeringAngleGivesTheYawRateBack) {
  for (const double speed : {-3.0, 0.5, 10.0}) {
    for (const double yaw_rate : {-0.7, 0.0, 0.2}) {
      const double phi = steering_angle(increment(0.02, speed, yaw_rate), 1.3);
      EXPECT_NEAR(speed / 1.3 * std::tan(phi), yaw_rate, 1e-12);
    }
  }
  EXPECT_EQ(steering_angle(increment(0.02, 0.0, 0.3), 1.3), 0.0);
}

/// Eq. (3) as printed, with its division by omega.
Pose2 printed_arc(const Pose2& pose, const OdometryIncrement& u) {
  const double radius = u.speed / u.yaw_rate;
  const double turned = pose.yaw + u.yaw_rate * u.duration;
  return {pose.x + radius * (std::sin(turned) - std::sin(pose.yaw)),
          pose.y - radius * (std::cos(turned) - std::cos(pose.yaw)), turned};
}

TEST(SteeringMotion, WithoutNoiseFollowsTheArcOfEquation3) {
  SteeringNoiseParameters parameters;
  parameters.noise_scale = 0.0;
  const Pose2 start{1.0, -2.0, 0.4};
  for (const double yaw_rate : {-1.0, -0.01, 0.3, 2.0}) {
    const OdometryIncrement u = increment(0.5, 3.0, yaw_rate);
    RandomStream random(1, 0, 0);
    const Pose2 end = SteeringMotion(u, parameters).sample(start, random);
    const Pose2 expected = printed_arc(start, u);
    EXPECT_NEAR(end.x, expected.x, 1e-12);
    EXPECT_NEAR(end.y, expected.y, 1e-12);
    EXPECT_NEAR(angle_difference(end.yaw, expected.yaw), 0.0, 1e-12);
  }
}

TEST(SteeringMotion, HasNoSingularityStraightAhead) {
  SteeringNoiseParameters parameters;
  parameters.noise_scale = 0.0;
  RandomStream random(1, 0, 0);
  const Pose2 straight = SteeringMotion(increment(0.5, 3.0, 0.0), parameters).sample({}, random);
  const Pose2 nearly = SteeringMotion(increment(0.5, 3.0, 1e-9), parameters).sample({}, random);
  EXPECT_NEAR(straight.x, 1.5, 1e-15);
  EXPECT_EQ(straight.y, 0.0);
  EXPECT_NEAR(nearly.x, straight.x, 1e-9);
  EXPECT_NEAR(nearly.y, straight.y, 1e-9);
}

struct Spread {
  double mean_x = 0.0;
  double variance_x = 0.0;
  double variance_yaw = 0.0;
};

Spread spread_of_one_second(int steps, double speed, const SteeringNoiseParameters& parameters) {
  constexpr std::uint32_t kSamples = 4000;
  Spread spread;
  double sum_of_squares = 0.0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    Pose2 pose;
    for (int k = 0; k < steps; ++k) {
      RandomStream random(2, static_cast<std::uint32_t>(k), i);
      pose = SteeringMotion(increment(1.0 / steps, speed, 0.0), parameters).sample(pose, random);
    }
    spread.mean_x += pose.x / kSamples;
    sum_of_squares += pose.x * pose.x / kSamples;
    spread.variance_yaw += pose.yaw * pose.yaw / kSamples;
  }
  spread.variance_x = sum_of_squares - spread.mean_x * spread.mean_x;
  return spread;
}

TEST(SteeringMotion, SpeedNoiseIsThatOfEquation5) {
  SteeringNoiseParameters parameters;
  parameters.alpha3 = parameters.alpha4 = parameters.alpha5 = parameters.alpha6 = 0.0;
  parameters.noise_scale = 1.0;
  parameters.noise_period = 1.0;
  const Spread spread = spread_of_one_second(1, 2.0, parameters);
  EXPECT_NEAR(spread.mean_x, 2.0, 0.2);
  EXPECT_NEAR(spread.variance_x, 3.0 * 4.0, 12.0 * 4.0 * std::sqrt(2.0 / 4000.0));
}

TEST(SteeringMotion, YawNoiseIsThatOfEquations6And7) {
  SteeringNoiseParameters parameters;
  parameters.alpha1 = parameters.alpha2 = 0.0;
  parameters.noise_scale = 1e-4;
  parameters.noise_period = 1.0;
  const double expected = 1e-4 * 3.0 * 4.0 * (1.0 + 4.0);  // steering through v / l, and gamma itself
  EXPECT_NEAR(spread_of_one_second(1, 2.0, parameters).variance_yaw, expected, 0.1 * expected);
}

TEST(SteeringMotion, NoiseOfASecondDoesNotDependOnTheOdometryRate) {
  const SteeringNoiseParameters parameters;
  const Spread slow = spread_of_one_second(5, 2.0, parameters);
  const Spread fast = spread_of_one_second(50, 2.0, parameters);
  EXPECT_NEAR(slow.variance_yaw / fast.variance_yaw, 1.0, 0.15);
  EXPECT_NEAR(slow.variance_x / fast.variance_x, 1.0, 0.15);
}

TEST(SteeringMotion, StandingStillDiffusesNothing) {
  RandomStream random(3, 0, 0);
  const Pose2 start{1.0, 2.0, 0.5};
  const Pose2 end = SteeringMotion(increment(0.02, 0.0, 0.0), {}).sample(start, random);
  EXPECT_EQ(end.x, start.x);
  EXPECT_EQ(end.y, start.y);
  EXPECT_EQ(end.yaw, start.yaw);
}

TEST(SteeringMotion, GyroBiasDoesNotTurnAParkedRobotButATurnOnTheSpotDoes) {
  RandomStream random(3, 0, 0);
  EXPECT_EQ(SteeringMotion(increment(0.5, 0.0, 0.02), {}).sample({}, random).yaw, 0.0);
  const Pose2 turned = SteeringMotion(increment(0.5, 0.0, 0.8), {}).sample({}, random);
  EXPECT_NEAR(turned.yaw, 0.4, 1e-12);
  EXPECT_EQ(turned.x, 0.0);
}

TEST(SteeringMotion, PrintedNoiseStaysFinite) {
  SteeringNoiseParameters parameters;
  parameters.noise_scale = 1.0;
  parameters.max_steering_angle = 1.57;
  Pose2 pose;
  for (std::uint32_t k = 0; k < 10000; ++k) {
    RandomStream random(4, k, 0);
    pose = SteeringMotion(increment(0.01, 10.0, 1.0), parameters).sample(pose, random);
    ASSERT_TRUE(pose.finite());
    ASSERT_LE(std::abs(pose.yaw), kPi);
  }
}

TEST(MotionJacobians, EqualCentralDifferences) {
  constexpr double kStep = 1e-6;
  for (const double yaw_rate : {-1.5, 0.0, 1e-5, 0.4}) {
    for (const double speed : {-2.0, 0.0, 5.0}) {
      const Pose2 pose{1.0, 2.0, 2.5};
      const OdometerErrors errors{0.03, 0.01};
      const OdometryIncrement u = increment(0.4, speed, yaw_rate);
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

}  // namespace
}  // namespace multipath_localization
