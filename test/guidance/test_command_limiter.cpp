#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "multipath_localization/guidance/command_limiter.hpp"

namespace multipath_localization {
namespace {

CommandLimiter limiter() {
  CommandLimits limits;
  limits.max_acceleration = 1.0;
  limits.max_deceleration = 2.0;
  limits.emergency_deceleration = 4.0;
  limits.max_steering_rate = 0.5;
  limits.max_jerk = 1e6;
  return {limits, 0.5};
}

/// Brought to 1.5 m/s and 0.2 rad.
CommandLimiter driving() {
  CommandLimiter base = limiter();
  for (int i = 0; i < 20; ++i) base.limited({1.5, 0.2}, false, 0.1);
  return base;
}

TEST(CommandLimiter, KeepsAccelerationAndSteeringRate) {
  CommandLimiter base = limiter();
  const MotionCommand first = base.limited({1.5, -0.3}, false, 0.1);
  EXPECT_NEAR(first.speed, 0.1, 1e-12);
  EXPECT_NEAR(first.steering_angle, -0.05, 1e-12);
  for (int i = 0; i < 20; ++i) base.limited({1.5, -0.3}, false, 0.1);
  EXPECT_EQ(base.last().speed, 1.5);
  EXPECT_EQ(base.last().steering_angle, -0.3);
}

TEST(CommandLimiter, BrakesAlongItsArcAndInAnEmergencyHarder) {
  CommandLimiter base = driving();
  EXPECT_NEAR(base.limited({}, false, 0.1).speed, 1.3, 1e-12);
  EXPECT_NEAR(base.limited({}, true, 0.1).speed, 0.9, 1e-12);
  EXPECT_EQ(base.last().steering_angle, 0.2);
  for (int i = 0; i < 3; ++i) base.limited({}, true, 0.1);
  EXPECT_EQ(base.last().speed, 0.0);
  for (int i = 0; i < 4; ++i) base.limited({}, true, 0.1);
  EXPECT_NEAR(base.last().steering_angle, 0.0, 1e-12);
}

CommandLimiter gentle() {
  CommandLimits limits;
  limits.max_jerk = 2.0;
  return {limits, 0.5};
}

/// Every few seconds another speed is wanted, forwards or back, also before the last one is reached.
TEST(CommandLimiter, KeepsTheJerkAndComesToEachSpeedWithoutPassingIt) {
  constexpr double kStep = 0.02;  // [s]
  CommandLimiter base = gentle();
  double speed = 0.0;
  double acceleration = 0.0;
  for (const auto& [wanted, steps] : std::vector<std::pair<double, int>>{
           {1.5, 200}, {0.4, 150}, {0.41, 50}, {3.0, 20}, {0.0, 200}, {-1.0, 200}, {1.0, 250}, {0.0, 200}}) {
    for (int i = 0; i < steps; ++i) {
      const double now = base.limited({wanted, 0.0}, false, kStep).speed;
      ASSERT_LE(std::abs((now - speed) / kStep - acceleration), 2.0 * kStep + 1e-6) << wanted << " " << i;
      ASSERT_LE(std::abs(now - speed), 1.0 * kStep + 1e-9);
      acceleration = (now - speed) / kStep;
      speed = now;
    }
    if (steps > 100) {
      EXPECT_EQ(speed, wanted);
    }
  }
}

TEST(CommandLimiter, BrakesInAnEmergencyAtOnce) {
  CommandLimiter base = gentle();
  for (int i = 0; i < 200; ++i) base.limited({1.5, 0.0}, false, 0.02);
  EXPECT_NEAR(base.limited({}, true, 0.02).speed, 1.46, 1e-9);
}

TEST(CommandLimiter, MakesNoJumpOfASilenceNorOfTimeThatRunsBack) {
  CommandLimiter base = driving();
  EXPECT_NEAR(base.limited({}, false, 1e9).speed, 1.5 - 2.0 * CommandLimiter::kLongestStep, 1e-12);
  const double before = base.last().speed;
  EXPECT_EQ(base.limited({}, false, -3.0).speed, before);
  EXPECT_EQ(base.limited({}, false, std::numeric_limits<double>::quiet_NaN()).speed, before);
}

TEST(CommandLimiter, CarriesAPoseForwardAlongTheLastCommand) {
  const CommandLimiter base = driving();
  const Pose2 now = base.carried_forward({1.0, 2.0, 0.0}, 0.1);
  const double turn = 0.1 * 1.5 * std::tan(0.2) / 0.5;
  EXPECT_NEAR(now.yaw, turn, 1e-12);
  EXPECT_NEAR(now.x, 1.0 + 0.15 * std::sin(turn) / turn, 1e-9);
  const Pose2 ahead = base.carried_forward({1.0, 2.0, 0.0}, -0.1);
  EXPECT_EQ(ahead.x, 1.0);
  EXPECT_EQ(base.carried_forward({1.0, 2.0, 0.0}, std::numeric_limits<double>::quiet_NaN()).x, 1.0);
}

}  // namespace
}  // namespace multipath_localization
