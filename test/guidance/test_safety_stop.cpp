#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/guidance/safety_stop.hpp"

namespace multipath_localization {
namespace {

constexpr double kDeceleration = 1.0;  // [m/s^2]
const FollowerOutput kDrive{{1.5, 0.1}, "driving"};

SafetyParameters safety() {
  SafetyParameters p;
  p.obstacle_distance = 0.5;
  p.clear_time = 1.0;
  return p;
}

Hazards obstacle(double free_way) {
  Hazards hazards;
  hazards.free_way = free_way;
  return hazards;
}

void expect_halted(const FollowerOutput& output, const std::string& status) {
  EXPECT_EQ(output.command.speed, 0.0);
  EXPECT_EQ(output.spin, 0.0);
  EXPECT_EQ(output.status, status);
  EXPECT_TRUE(output.urgent);
}

TEST(SafetyStop, LeavesACommandAloneWhereNothingSpeaksAgainstIt) {
  SafetyStop stop(safety(), kDeceleration);
  const FollowerOutput output = stop.guarded(kDrive, 1.5, {}, 0.0);
  EXPECT_EQ(output.command.speed, 1.5);
  EXPECT_EQ(output.status, "driving");
  EXPECT_EQ(stop.reason(), "");
}

TEST(SafetyStop, HaltsAsLongAsItIsAskedToAndForTheClearTime) {
  SafetyStop stop(safety(), kDeceleration);
  Hazards asked;
  asked.stop_asked = true;
  expect_halted(stop.guarded(kDrive, 1.5, asked, 10.0), "stopped: emergency stop");
  EXPECT_EQ(stop.reason(), "emergency stop");
  expect_halted(stop.guarded(kDrive, 0.0, {}, 10.9), "stopped: emergency stop");
  EXPECT_EQ(stop.guarded(kDrive, 0.0, {}, 11.0).command.speed, 1.5);
  EXPECT_EQ(stop.guarded(kDrive, 0.0, {}, 11.1).command.speed, 1.5);
}

TEST(SafetyStop, HaltsWhereAnInputThatHasToSpeakIsSilent) {
  SafetyParameters p = safety();
  p.max_stop_input_age = 1.0;
  SafetyStop stop(p, kDeceleration);
  Hazards hazards;
  expect_halted(stop.guarded(kDrive, 1.5, hazards, 0.0), "stopped: emergency_stop is silent");
  hazards.stop_input_age = 0.9;
  EXPECT_EQ(stop.guarded(kDrive, 0.0, hazards, 2.0).command.speed, 1.5);
  hazards.stop_input_age = 1.1;
  hazards.scan_fault = "no scan yet";
  expect_halted(stop.guarded(kDrive, 0.0, hazards, 3.0), "stopped: emergency_stop is silent");
  hazards.stop_input_age = 0.0;
  expect_halted(stop.guarded(kDrive, 0.0, hazards, 3.0), "stopped: no scan yet");
}

TEST(SafetyStop, SlowsSoThatItStopsBeforeAnObstacle) {
  SafetyStop stop(safety(), kDeceleration);
  double way = 4.0;
  double speed = 1.5;
  for (double now = 0.0; now < 20.0; now += 0.02) {
    const FollowerOutput output = stop.guarded(kDrive, speed, obstacle(way), now);
    EXPECT_FALSE(output.urgent && output.command.speed > 0.0);
    EXPECT_LE(speed - output.command.speed, kDeceleration * 0.02 + 0.051);
    speed = output.command.speed;
    way -= 0.02 * speed;
  }
  EXPECT_EQ(speed, 0.0);
  EXPECT_GT(way, 0.49);
  EXPECT_LT(way, 0.52);
  expect_halted(stop.guarded(kDrive, speed, obstacle(way), 20.0), "stopped: obstacle 0.5 m ahead");
}

TEST(SafetyStop, BrakesUrgentlyBeforeWhatComesUpSuddenly) {
  SafetyStop stop(safety(), kDeceleration);
  EXPECT_TRUE(stop.guarded(kDrive, 1.5, obstacle(1.0), 0.0).urgent);
  EXPECT_FALSE(stop.guarded(kDrive, 1.0, obstacle(1.1), 0.0).urgent);
  EXPECT_EQ(stop.guarded(kDrive, 1.0, obstacle(1.1), 0.0).status, "slow: obstacle 1.1 m ahead");
}

TEST(SafetyStop, GoesOnOnlyWhenAnObstacleIsSomeWayOff) {
  SafetyStop stop(safety(), kDeceleration);
  expect_halted(stop.guarded(kDrive, 0.0, obstacle(0.4), 0.0), "stopped: obstacle 0.4 m ahead");
  expect_halted(stop.guarded(kDrive, 0.0, obstacle(0.6), 5.0), "stopped: obstacle 0.6 m ahead");
  EXPECT_GT(stop.guarded(kDrive, 0.0, obstacle(0.8), 6.0).command.speed, 0.0);
}

TEST(SafetyStop, SlowsABaseThatDrivesBackToo) {
  SafetyStop stop(safety(), kDeceleration);
  const FollowerOutput output = stop.guarded({{-1.5, 0.0}, "driving"}, -1.0, obstacle(1.1), 0.0);
  EXPECT_NEAR(output.command.speed, -std::sqrt(2.0 * 0.8 * 0.6), 1e-9);
}

TEST(SafetyStop, DoesNotTurnOnTheSpotIntoAnObstacle) {
  SafetyStop stop(safety(), kDeceleration);
  const FollowerOutput spin{{}, "driving", false, 0.5};
  Hazards hazards = obstacle(0.0);
  EXPECT_EQ(stop.guarded(spin, 0.0, hazards, 0.0).spin, 0.5);  // it turns away from what is ahead
  hazards.free_to_turn = false;
  expect_halted(stop.guarded(spin, 0.0, hazards, 0.0), "stopped: obstacle, no room to turn");
}

TEST(SafetyStop, SaysNothingOfARobotThatStandsAnyway) {
  SafetyStop stop(safety(), kDeceleration);
  EXPECT_EQ(stop.guarded({{}, "finished"}, 0.0, obstacle(0.1), 0.0).status, "finished");
  EXPECT_EQ(stop.reason(), "");
}

TEST(SafetyStop, LooksAsFarAsBrakingTakes) {
  const SafetyStop stop(safety(), kDeceleration);
  EXPECT_GT(stop.look_ahead(0.0), 0.5);
  for (const double speed : {0.5, 1.5, 5.0, -5.0}) {
    EXPECT_GT(stop.look_ahead(speed), 0.5 + speed * speed / (2.0 * 0.8 * kDeceleration));
  }
}

TEST(SafetyParameters, ATypoIsRefused) {
  SafetyParameters p;
  EXPECT_THROW(load(YAML::Load("{obstacle_distanc: 1.0}"), p), ParameterError);
  load(YAML::Load("{obstacle_distance: 1.0, width: 2.0}"), p);
  EXPECT_EQ(p.footprint.width, 2.0);
}

}  // namespace
}  // namespace multipath_localization
