#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/robot.hpp"

namespace multipath_localization {
namespace {

RobotParameters agile() {
  RobotParameters parameters;
  parameters.max_acceleration = 1e6;
  parameters.max_steering_rate = 1e6;
  return parameters;
}

TEST(Robot, DrivesTheCircleOfItsSteeringAngle) {  // Eqs. (3) and (4) of [NIS]
  const MotionCommand u{2.0, std::atan(0.5)};     // radius 2 m at wheelbase 1 m
  Robot robot(agile(), 1);
  const int steps = 1000;
  for (int i = 0; i < steps; ++i) robot.step(u, 2.0 * kPi / steps);  // one turn at 1 rad/s
  EXPECT_NEAR(robot.pose().position().norm(), 0.0, 1e-9);
  for (int i = 0; i < steps / 2; ++i) robot.step(u, 2.0 * kPi / steps);
  EXPECT_NEAR((robot.pose().position() - Eigen::Vector2d(0.0, 4.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(robot.yaw_rate(), 1.0, 1e-12);
}

TEST(Robot, StrafesBesideWhatItIsCommandedWhereItCan) {
  RobotParameters parameters = agile();
  parameters.strafes = {{1.0, 2.0, 0.5}};
  parameters.drive = DriveKind::kOmnidirectional;
  Robot robot(parameters, 1);
  for (int i = 0; i < 400; ++i) robot.step({1.0, 0.0}, 0.01);
  EXPECT_NEAR(robot.pose().x, 4.0, 1e-6);
  EXPECT_NEAR(robot.pose().y, 1.0, 0.01);
  EXPECT_EQ(robot.lateral_speed(), 0.0);
  parameters.drive = DriveKind::kDifferential;
  Robot wheeled(parameters, 1);
  for (int i = 0; i < 400; ++i) wheeled.step({1.0, 0.0}, 0.01);
  EXPECT_EQ(wheeled.pose().y, 0.0);
}

TEST(Robot, StrafesOnTheArcItTurnsBy) {
  RobotParameters parameters = agile();
  parameters.strafes = {{0.0, 10.0, 0.5}};
  parameters.drive = DriveKind::kOmnidirectional;
  Robot robot(parameters, 1);
  for (int i = 0; i < 100; ++i) robot.step(motion_command(1.0, 0.3, parameters.wheelbase), 0.01);
  const Pose2 expected = displacement({1.0, 1.0, 1.0, 0.3, 0.5});
  EXPECT_NEAR((robot.pose().position() - expected.position()).norm(), 0.0, 1e-6);
}

TEST(Robot, KeepsWithinItsLimits) {
  RobotParameters parameters;
  parameters.max_speed = 2.0;
  parameters.max_acceleration = 1.0;
  parameters.max_steering_angle = 0.4;
  parameters.max_steering_rate = 0.5;
  Robot robot(parameters, 1);
  robot.step({100.0, -100.0}, 0.1);
  EXPECT_NEAR(robot.command().speed, 0.1, 1e-12);
  EXPECT_NEAR(robot.command().steering_angle, -0.05, 1e-12);
  for (int i = 0; i < 100; ++i) robot.step({100.0, -100.0}, 0.1);
  EXPECT_DOUBLE_EQ(robot.speed(), 2.0);
  EXPECT_DOUBLE_EQ(robot.command().steering_angle, -0.4);
}

TEST(Robot, TakesACommandThatIsNotFiniteForAStop) {
  Robot robot(agile(), 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const MotionCommand& bad :
       {MotionCommand{nan, 0.0}, MotionCommand{1.0, nan}, MotionCommand{infinity, 0.0}}) {
    robot.step({1.0, 0.2}, 0.1);
    robot.step(bad, 0.1);
    EXPECT_EQ(robot.speed(), 0.0);
    EXPECT_TRUE(robot.pose().finite());
  }
}

TEST(Robot, StraysByTheNoiseOfItsConstants) {  // Eqs. (5)-(7) of [NIS]
  RobotParameters parameters = agile();
  parameters.alpha = {1.0, 0.0, 0.0, 0.0, 4.0, 0.0};
  parameters.noise_scale = 0.01;
  Robot robot(parameters, 1);
  const int steps = 4000;
  double speed_squares = 0.0;
  double yaw_rate_squares = 0.0;
  for (int i = 0; i < steps; ++i) {
    robot.step({2.0, 0.0}, 0.01);
    speed_squares += std::pow(robot.speed() - 2.0, 2);
    yaw_rate_squares += std::pow(robot.yaw_rate(), 2);
  }
  EXPECT_NEAR(std::sqrt(speed_squares / steps), 0.2, 0.01);     // 0.1 * 2 m/s, 4.5 sigma
  EXPECT_NEAR(std::sqrt(yaw_rate_squares / steps), 0.4, 0.02);  // 0.1 * 2 * 2 m/s
}

TEST(Robot, StraysInSteeringByItsNoise) {  // Eq. (6) of [NIS]
  RobotParameters parameters = agile();
  parameters.alpha = {0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  parameters.noise_scale = 1e-4;
  Robot robot(parameters, 1);
  const int steps = 4000;
  double squares = 0.0;
  for (int i = 0; i < steps; ++i) {
    robot.step({2.0, 0.0}, 0.01);
    squares += std::pow(std::atan(robot.yaw_rate() / 2.0), 2);
  }
  EXPECT_NEAR(std::sqrt(squares / steps), 0.02, 0.001);
}

TEST(Robot, StandsStillWhenParkedWithTheWheelTurned) {
  RobotParameters parameters = agile();
  parameters.noise_scale = 1.0;
  Robot robot(parameters, 1);
  for (int i = 0; i < 100; ++i) robot.step({0.0, 0.5}, 0.01);
  EXPECT_EQ(robot.pose().position().norm(), 0.0);
  EXPECT_EQ(robot.pose().yaw, 0.0);
}

RobotParameters on_two_wheels() {
  RobotParameters parameters = agile();
  parameters.drive = DriveKind::kDifferential;
  parameters.wheel_separation = 0.35;
  return parameters;
}

TEST(Robot, OnTwoWheelsTurnsAsOneThatSteers) {
  const MotionCommand u{2.0, std::atan(0.5)};
  Robot rolling(on_two_wheels(), 1);
  Robot steered(agile(), 1);
  for (int i = 0; i < 300; ++i) {
    rolling.step(u, 0.01);
    steered.step(u, 0.01);
  }
  EXPECT_NEAR((rolling.pose().position() - steered.pose().position()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(rolling.yaw_rate(), 1.0, 1e-12);
}

TEST(Robot, OnTwoWheelsStraysByTheNoiseOfEither) {  // Table 2 of [KAM]
  RobotParameters parameters = on_two_wheels();
  parameters.wheel_noise = 0.3;
  Robot robot(parameters, 1);
  const int steps = 8000;
  double speed_squares = 0.0;
  double yaw_rate_squares = 0.0;
  for (int i = 0; i < steps; ++i) {
    robot.step({0.25, 0.0}, 0.01);
    speed_squares += std::pow(robot.speed() - 0.25, 2);
    yaw_rate_squares += std::pow(robot.yaw_rate(), 2);
  }
  EXPECT_NEAR(std::sqrt(speed_squares / steps), 0.3 / std::sqrt(2.0), 0.008);  // 4.5 sigma
  EXPECT_NEAR(std::sqrt(yaw_rate_squares / steps), 0.3 * std::sqrt(2.0) / 0.35, 0.045);
}

TEST(Robot, OnTwoWheelsStandsStillWhenParked) {
  RobotParameters parameters = on_two_wheels();
  parameters.wheel_noise = 1.0;
  Robot robot(parameters, 1);
  for (int i = 0; i < 100; ++i) robot.step({0.0, 0.5}, 0.01);
  EXPECT_EQ(robot.pose().position().norm(), 0.0);
  EXPECT_EQ(robot.pose().yaw, 0.0);
}

TEST(Robot, NeedsSixNoiseConstants) {
  RobotParameters parameters;
  parameters.alpha = {3.0, 0.3};
  EXPECT_THROW(Robot(parameters, 1), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
