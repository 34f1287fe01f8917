#include <gtest/gtest.h>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/localization/standstill.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;

/// Sum of the yaw rates that are left [rad], of `seconds` at this speed and yaw rate, with noise.
double turned(Standstill& standstill, double seconds, double speed, double yaw_rate, double noise = 0.0) {
  double turn = 0.0;
  for (std::uint32_t i = 0; i * kStep < seconds; ++i) {
    RandomStream random(1, i, 0);
    const OdometryIncrement u{kStep * i, kStep, speed, yaw_rate + noise * random.normal()};
    turn += standstill.settled(u).yaw_rate * kStep;
  }
  return turn;
}

TEST(Standstill, AGyroTurnsNoParkedRobot) {
  Standstill standstill;
  EXPECT_EQ(turned(standstill, 600.0, 0.0, 0.01), 0.0);
  EXPECT_EQ(turned(standstill, 600.0, 0.005, 0.005, 0.01), 0.0);
  EXPECT_TRUE(standing(standstill.settled({0.0, kStep, 0.0, 0.01})));
}

TEST(Standstill, ATurnOnTheSpotCountsHoweverSlow) {
  Standstill slow, fast, left;
  EXPECT_NEAR(turned(slow, 20.0, 0.0, 0.03, 0.01), 0.6, 0.05);
  EXPECT_NEAR(turned(fast, 2.0, 0.0, 0.5), 1.0, 1e-9);
  EXPECT_NEAR(turned(left, 20.0, 0.0, -0.06), -1.2, 0.02);
}

TEST(Standstill, SpeedAboutTheLimitLosesNothingOfATurn) {
  Standstill standstill;
  double turn = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const OdometryIncrement u{kStep * i, kStep, i % 2 == 0 ? 0.0 : 1.5 * kStandstillSpeed, 0.03};
    turn += standstill.settled(u).yaw_rate * kStep;
  }
  EXPECT_NEAR(turn, 0.6, 0.02);
}

TEST(Standstill, TicksOfASlowWheelThatIsReadOftenAreNoStandstill) {
  constexpr double kTick = 0.005, kOften = 0.001;
  for (const double speed : {0.05, 0.3}) {
    Standstill standstill;
    double turn = 0.0, told = 0.0, way = 0.0;
    for (int i = 0; i < 20000; ++i) {
      const bool tick = speed * kOften * i - told >= kTick;
      if (tick) told += kTick;
      const OdometryIncrement u{kOften * i, kOften, tick ? kTick / kOften : 0.0, 0.015};
      const OdometryIncrement settled = standstill.settled(u);
      turn += settled.yaw_rate * kOften;
      way += settled.speed * kOften;
    }
    EXPECT_NEAR(turn, 0.3, 0.01) << speed;
    EXPECT_NEAR(way, 20.0 * speed, 2.0 * kTick) << speed;
  }
  Standstill trembling;
  double turn = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double tick = i % 200 == 0 ? kTick : i % 200 == 100 ? -kTick : 0.0;
    turn += trembling.settled({kOften * i, kOften, tick / kOften, 0.01}).yaw_rate * kOften;
  }
  EXPECT_LT(turn, 0.1) << "a wheel that trembles about a tick";
}

TEST(Standstill, SettlesAWholeDriveInOrder) {
  const std::vector<OdometryIncrement> drive = {
      {1.0, 1.0, 0.5, 0.01}, {2.0, 1.0, 0.0, 0.01}, {3.0, 1.0, 0.0, 0.3}};
  const std::vector<OdometryIncrement> result = settled(drive);
  ASSERT_EQ(result.size(), 3U);
  EXPECT_EQ(result[0].yaw_rate, 0.01);
  EXPECT_EQ(result[1].yaw_rate, 0.0);
  EXPECT_EQ(result[2].yaw_rate, 0.3);
}

/// Sum of the lateral speeds that are left [m], of `seconds` of this lateral speed, with noise.
double strafed(Standstill& standstill, double seconds, double lateral_speed, double noise) {
  double way = 0.0;
  for (std::uint32_t i = 0; i * kStep < seconds; ++i) {
    RandomStream random(2, i, 0);
    const OdometryIncrement u{kStep * i, kStep, 0.0, 0.01, lateral_speed + noise * random.normal()};
    way += standstill.settled(u).lateral_speed * kStep;
  }
  return way;
}

TEST(Standstill, NoiseOfTheLateralSpeedMovesNoParkedRobot) {
  Standstill standstill;
  EXPECT_EQ(strafed(standstill, 600.0, 0.005, 0.01), 0.0);
  EXPECT_TRUE(standing(standstill.settled({0.0, kStep, 0.0, 0.01, 0.01})));
}

TEST(Standstill, AStrafingRobotDoesNotStand) {
  Standstill standstill;
  EXPECT_NEAR(strafed(standstill, 20.0, -0.3, 0.02), -6.0, 0.1);
  const OdometryIncrement u = standstill.settled({0.0, kStep, 0.0, 0.01, -0.3});
  EXPECT_FALSE(standing(u));
  EXPECT_EQ(u.yaw_rate, 0.01) << "as of any robot that moves";
}

TEST(Standstill, ARobotThatDrivesStaysAsItIs) {
  Standstill standstill;
  EXPECT_NEAR(turned(standstill, 10.0, 0.5, 0.001), 0.01, 1e-12);
  const OdometryIncrement u{3.0, kStep, -0.5, 0.001};
  const OdometryIncrement settled = standstill.settled(u);
  EXPECT_EQ(settled.speed, u.speed);
  EXPECT_EQ(settled.stamp, u.stamp);
  EXPECT_EQ(settled.duration, u.duration);
}

}  // namespace
}  // namespace multipath_localization
