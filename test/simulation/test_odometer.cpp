#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulation/odometer.hpp"

namespace multipath_localization {
namespace {

/// What an odometer says over `duration` [s] of steps of 0.01 s at 2 m/s and 0.5 rad/s.
std::vector<OdometryIncrement> watch(Odometer& odometer, double duration, double noise_scale = 0.0) {
  RobotParameters parameters;
  parameters.max_acceleration = parameters.max_steering_rate = 1e6;
  parameters.noise_scale = noise_scale;
  Robot robot(parameters, 1);
  std::vector<OdometryIncrement> all;
  const auto steps = std::lround(duration / 0.01);
  for (long i = 1; i <= steps; ++i) {
    robot.step(motion_command(2.0, 0.5, 1.0), 0.01);
    if (const auto u = odometer.step(robot, static_cast<double>(i) * 0.01, 0.01)) all.push_back(*u);
  }
  return all;
}

TEST(Odometer, MeasuresTheMotionAtItsRate) {
  OdometerParameters parameters;
  parameters.rate = 20.0;
  Odometer odometer(parameters, 1);
  const auto increments = watch(odometer, 10.0);
  ASSERT_EQ(increments.size(), 200U);
  for (std::size_t i = 0; i < increments.size(); ++i) {
    EXPECT_NEAR(increments[i].stamp, 0.05 * static_cast<double>(i + 1), 1e-9);
    EXPECT_NEAR(increments[i].duration, 0.05, 1e-9);
    EXPECT_NEAR(increments[i].speed, 2.0, 1e-9);
    EXPECT_NEAR(increments[i].yaw_rate, 0.5, 1e-9);
  }
}

TEST(Odometer, MeasuresTheWaySideways) {
  RobotParameters robot_parameters;
  robot_parameters.drive = DriveKind::kOmnidirectional;
  robot_parameters.max_acceleration = 1e6;
  robot_parameters.strafes = {{0.0, 10.0, -0.5}};
  Robot robot(robot_parameters, 1);
  OdometerParameters parameters;
  parameters.rate = 20.0;
  parameters.speed_scale_error = 0.1;
  parameters.speed_noise = 0.01;
  Odometer odometer(parameters, 1);
  double way = 0.0;
  for (int i = 1; i <= 500; ++i) {
    robot.step({}, 0.01);
    if (const auto u = odometer.step(robot, 0.01 * i, 0.01)) way += u->lateral_speed * u->duration;
  }
  EXPECT_NEAR(way, -1.1 * 2.5, 0.02);
}

TEST(Odometer, FasterThanTheSimulationReportsEveryStep) {
  OdometerParameters parameters;
  parameters.rate = 300.0;
  Odometer odometer(parameters, 1);
  EXPECT_EQ(watch(odometer, 1.0).size(), 100U);
}

TEST(Odometer, OfTheCommandDoesNotSeeTheNoiseOfTheMotion) {
  OdometerParameters parameters;
  parameters.source = OdometerSource::kCommand;
  Odometer odometer(parameters, 1);
  for (const OdometryIncrement& u : watch(odometer, 1.0, 1e-3)) {
    EXPECT_NEAR(u.speed, 2.0, 1e-9);
    EXPECT_NEAR(u.yaw_rate, 0.5, 1e-9);
  }
  Odometer of_motion(OdometerParameters{}, 1);
  EXPECT_GT(std::abs(watch(of_motion, 1.0, 1e-3).front().speed - 2.0), 1e-3);
}

TEST(Odometer, HasTheErrorsOfItsParameters) {
  OdometerParameters parameters;
  parameters.rate = 100.0;
  parameters.speed_scale_error = 0.01;
  parameters.speed_noise = 0.03;
  parameters.speed_noise_ratio = 0.02;
  parameters.gyro_bias = 0.1;
  parameters.yaw_rate_noise = 0.02;
  Odometer odometer(parameters, 1);
  const auto increments = watch(odometer, 40.0);
  const auto n = static_cast<double>(increments.size());
  double speed = 0.0, turn = 0.0, speed_squares = 0.0, turn_squares = 0.0;
  for (const OdometryIncrement& u : increments) {
    speed += u.speed / n;
    turn += u.yaw_rate / n;
    speed_squares += std::pow(u.speed - 2.02, 2) / n;
    turn_squares += std::pow(u.yaw_rate - 0.6, 2) / n;
  }
  EXPECT_NEAR(speed, 2.02, 0.0035);  // 4.5 sigma over 4000 draws, here and below
  EXPECT_NEAR(turn, 0.6, 0.0015);
  EXPECT_NEAR(std::sqrt(speed_squares), std::hypot(0.03, 0.0404), 0.0026);
  EXPECT_NEAR(std::sqrt(turn_squares), 0.02, 0.001);
}

TEST(Odometer, DrawsScaleAndGyroBiasBySeed) {
  OdometerParameters parameters;
  parameters.speed_scale_error_sigma = 0.02;
  parameters.gyro_bias_sigma = 0.004;
  const int seeds = 500;
  double scale_squares = 0.0, bias_squares = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    const Odometer odometer(parameters, static_cast<std::uint64_t>(seed));
    scale_squares += std::pow(odometer.scale() - 1.0, 2) / seeds;
    bias_squares += std::pow(odometer.gyro_bias(), 2) / seeds;
  }
  EXPECT_NEAR(std::sqrt(scale_squares), 0.02, 0.003);
  EXPECT_NEAR(std::sqrt(bias_squares), 0.004, 0.0006);
}

TEST(Odometer, CountsMoreWheelPathInASlip) {
  OdometerParameters parameters;
  parameters.rate = 10.0;
  parameters.slips = {{1.0, 0.5, 0.5}, {2.0, 0.1, -1.0}};
  Odometer odometer(parameters, 1);
  const auto increments = watch(odometer, 3.0);
  for (const OdometryIncrement& u : increments) {
    const double middle = u.stamp - 0.05;
    const double expected = middle > 1.0 && middle < 1.5 ? 3.0 : middle > 2.0 && middle < 2.1 ? 0.0 : 2.0;
    EXPECT_NEAR(u.speed, expected, 1e-9) << u.stamp;
    EXPECT_NEAR(u.yaw_rate, 0.5, 1e-9);
  }
}

TEST(Odometer, SlipsAtRandomAsOftenAsAsked) {
  OdometerParameters parameters;
  parameters.slip_rate = 0.5;
  parameters.slip_duration = 0.2;
  Odometer odometer(parameters, 1);
  Robot robot(RobotParameters{}, 1);
  int slips = 0;
  bool before = false;
  for (int i = 1; i <= 100000; ++i) {  // 1000 s: 500 / (1 + 0.1) slips
    odometer.step(robot, 0.01 * i, 0.01);
    slips += odometer.slipping() && !before ? 1 : 0;
    before = odometer.slipping();
  }
  EXPECT_NEAR(slips, 455, 90);
}

}  // namespace
}  // namespace multipath_localization
