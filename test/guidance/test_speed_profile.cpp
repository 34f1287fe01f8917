#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/guidance/speed_profile.hpp"

namespace multipath_localization {
namespace {

const SpeedLimits kLimits{3.0, 1.0, 0.5, 10.0, 1.0};

Path hook() { return Path({{0.0, 0.0}, {30.0, 0.0}, {30.0, 30.0}}, 1.0); }

TEST(SpeedProfile, KeepsTheLateralAccelerationInBends) {
  const Path path = hook();
  const SpeedProfile speed(path, kLimits, 0.0);
  const double bend = path.station(1);
  EXPECT_NEAR(speed.at(path, bend) * speed.at(path, bend) * path.at(bend).curvature, 1.0, 1e-9);
  EXPECT_EQ(speed.at(path, 5.0), 3.0);
}

TEST(SpeedProfile, KeepsTheYawRateInBends) {
  const Path path = hook();
  SpeedLimits limits = kLimits;
  limits.yaw_rate = 0.2;
  EXPECT_NEAR(SpeedProfile(path, limits, 0.0).at(path, path.station(1)) * path.at(path.station(1)).curvature,
              0.2, 1e-9);
}

TEST(SpeedProfile, BrakesForBendsAndTheEndAndNeverHarder) {
  const Path path = hook();
  const SpeedProfile speed(path, kLimits, 0.0);
  EXPECT_NEAR(speed.at(path, path.length()), 0.0, 1e-9);
  constexpr double kStep = 0.01;
  for (double s = 0.0; s + kStep < path.length(); s += kStep) {
    const double now = speed.at(path, s);
    const double next = speed.at(path, s + kStep);
    ASSERT_LE(now * now - next * next, 2.0 * kLimits.deceleration * kStep + 1e-9) << s;
    ASSERT_LE(now, kLimits.cruise_speed);
  }
}

TEST(SpeedProfile, GoesByTheBaseWhereItCannotFollowTheBend) {
  const Path path({{0.0, 0.0}, {10.0, 0.0}, {0.0, 0.5}}, 0.2);
  const SpeedProfile speed(path, kLimits, 3.0);
  ASSERT_GT(std::abs(path.at(path.station(1)).curvature), kLimits.tightest_curvature);
  EXPECT_NEAR(speed.at(path, path.station(1)), 1.0, 1e-9);
}

TEST(SpeedProfile, ComesToTheEndAtTheSpeedItIsTold) {
  const Path path = hook();
  EXPECT_EQ(SpeedProfile(path, kLimits, 3.0).at(path, path.length()), 3.0);
  EXPECT_GT(SpeedProfile(path, kLimits, 0.0).at(path, -1.0), 0.0);
  const Path place({{1.0, 1.0}}, 1.0);
  EXPECT_EQ(SpeedProfile(place, kLimits, 0.0).at(place, 0.0), 0.0);
}

TEST(SpeedProfile, KeepsTheSpeedOfEachZoneAndBrakesForIt) {
  const Path path = hook();
  const double corner = path.station(1);
  const SpeedProfile speed(path, kLimits, 3.0, {{corner, 2.0}, {path.length(), 0.4}});
  EXPECT_EQ(speed.at(path, 5.0), 2.0);
  EXPECT_NEAR(speed.at(path, corner), 0.4, 1e-9);  // in both
  EXPECT_EQ(speed.at(path, path.length()), 0.4);
  const double before = path.pieces()[1].begin - 1.0;
  EXPECT_NEAR(speed.at(path, before), std::sqrt(0.4 * 0.4 + 2.0 * 0.5 * 1.0), 1e-6);
}

/// Where the speed falls as told only 0.4 s later, it has fallen in time for the bend and the end.
TEST(SpeedProfile, BrakesEarlierByItsDelay) {
  const Path path({{0.0, 0.0}, {30.0, 0.0}}, 1.0);
  SpeedLimits limits = kLimits;
  limits.braking_delay = 0.4;
  const SpeedProfile late(path, limits, 0.0);
  const SpeedProfile at_once(path, kLimits, 0.0);
  for (double s = 15.0; s < 29.0; s += 0.5) {
    const double speed = late.at(path, s);
    EXPECT_NEAR(speed, at_once.at(path, s + 0.4 * speed), 1e-9) << s;
  }
  EXPECT_EQ(late.at(path, 5.0), 3.0);
  EXPECT_NEAR(late.at(path, 30.0), 0.0, 1e-9);
}

TEST(SpeedProfile, TellsHowLongAWayTakes) {
  const Path line({{0.0, 0.0}, {30.0, 0.0}}, 1.0);
  EXPECT_NEAR(SpeedProfile(line, kLimits, 3.0).duration(line, 0.0, 30.0), 10.0, 1e-6);
  EXPECT_NEAR(SpeedProfile(line, kLimits, 3.0).duration(line, 12.0, 15.0), 1.0, 1e-6);
  const double braking = SpeedProfile(line, kLimits, 0.0).duration(line, 0.0, 30.0);
  EXPECT_NEAR(braking, (30.0 - 9.0) / 3.0 + 6.0, 0.3);
  SpeedLimits standing = kLimits;
  standing.cruise_speed = 0.0;
  EXPECT_TRUE(std::isinf(SpeedProfile(line, standing, 0.0).duration(line, 0.0, 30.0)));
}

}  // namespace
}  // namespace multipath_localization
