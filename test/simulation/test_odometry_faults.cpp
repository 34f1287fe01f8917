#include <gtest/gtest.h>

#include <vector>

#include "../core/german_locale.hpp"
#include "simulation/odometry_faults.hpp"

namespace multipath_localization {
namespace {

constexpr double kStart = 1e6;

OdometryIncrement increment(double time, double speed = 2.0, double yaw_rate = 0.5) {
  return {kStart + time, 0.02, speed, yaw_rate};
}

OdometryFaults with_dead(const std::string& wheel) {
  OdometryFaultParameters parameters;
  parameters.dead_encoders.emplace_back();
  parameters.dead_encoders.back().wheel = wheel;
  parameters.dead_encoders.back().wheel_separation = 0.4;
  return {parameters, 1, kStart};
}

TEST(OdometryFaults, ASlipMultipliesTheSpeedForItsTime) {
  OdometryFaultParameters parameters;
  parameters.slips = {{1.0, 2.0, 0.5}};
  const OdometryFaults faults(parameters, 1, kStart);
  EXPECT_EQ(faults.distorted(increment(0.5)).speed, 2.0);
  EXPECT_EQ(faults.distorted(increment(1.5)).speed, 3.0);
  EXPECT_EQ(faults.distorted(increment(1.5)).yaw_rate, 0.5);
  EXPECT_EQ(faults.distorted(increment(3.5)).speed, 2.0);
}

TEST(OdometryFaults, ADeadEncoderHalvesTheSpeedAndTurnsTheRobot) {
  const OdometryIncrement straight = increment(1.0, 2.0, 0.0);
  const OdometryIncrement left = with_dead("left").distorted(straight);
  EXPECT_DOUBLE_EQ(left.speed, 1.0);
  EXPECT_DOUBLE_EQ(left.yaw_rate, 5.0) << "the right wheel alone, about the left one";
  const OdometryIncrement right = with_dead("right").distorted(straight);
  EXPECT_DOUBLE_EQ(right.speed, 1.0);
  EXPECT_DOUBLE_EQ(right.yaw_rate, -5.0);
  const OdometryIncrement both = with_dead("both").distorted(increment(1.0));
  EXPECT_EQ(both.speed, 0.0);
  EXPECT_EQ(both.yaw_rate, 0.0);
}

TEST(OdometryFaults, SpoilTheWaySidewaysAsTheWayAhead) {
  OdometryFaultParameters parameters;
  parameters.slips = {{0.0, 2.0, 0.5}};
  OdometryIncrement u = increment(1.0);
  u.lateral_speed = -1.0;
  EXPECT_EQ(OdometryFaults(parameters, 1, kStart).distorted(u).lateral_speed, -1.5);
  EXPECT_EQ(with_dead("left").distorted(u).lateral_speed, -0.5);
  EXPECT_EQ(with_dead("both").distorted(u).lateral_speed, 0.0);
}

TEST(OdometryFaults, WhatIsLostIsBridgedByTheNext) {
  OdometryFaultParameters parameters;
  parameters.losses.emplace_back();
  parameters.losses.back().share = 0.3;
  OdometryFaults faults(parameters, 1, kStart);
  double time = 0.0;
  int messages = 0;
  for (int i = 1; i <= 1000; ++i) {
    const auto out = faults.spoil(increment(0.02 * i));
    if (!out) continue;
    time += out->duration;
    EXPECT_NEAR(time, out->stamp - kStart, 1e-6);
    ++messages;
  }
  EXPECT_NEAR(messages, 700, 65);  // 4.5 sigma
}

TEST(OdometryFaults, SayWhatIsWrongNow) {
  OdometryFaultParameters parameters;
  parameters.slips = {{1.0, 2.0, 0.5}};
  const OdometryFaults faults(parameters, 1, kStart);
  const GermanLocale german;
  EXPECT_TRUE(faults.active(kStart).empty());
  EXPECT_EQ(faults.active(kStart + 1.0), std::vector<std::string>{"odometry: slip of 0.5"});
  EXPECT_EQ(with_dead("left").active(kStart), std::vector<std::string>{"odometry: left encoder dead"});
}

}  // namespace
}  // namespace multipath_localization
