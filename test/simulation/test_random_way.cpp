#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/random_ranges.hpp"
#include "simulation/random_way.hpp"

namespace multipath_localization {
namespace {

RandomWay way_of(std::uint64_t seed) {
  RandomStream random(seed, 0, 1);
  const double speed = draw(random, random_ranges::kSpeed);
  return draw_way(random, speed, 300.0, seed % 2 == 0, seed % 3 == 0);
}

TEST(RandomWay, IsTheMotionThatItSays) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<MotionStep> steps = drive_way(way_of(seed), seed);
    for (std::size_t i = 1; i < steps.size(); ++i) {
      const Pose2 expected =
          steps[i - 1].base_in_map * displacement({0.0, kWayStep, steps[i].speed, steps[i].yaw_rate});
      ASSERT_NEAR((steps[i].base_in_map.position() - expected.position()).norm(), 0.0, 1e-9);
      ASSERT_NEAR(angle_difference(steps[i].base_in_map.yaw, expected.yaw), 0.0, 1e-9);
    }
  }
}

TEST(RandomWay, KeepsToSpeedAndAccelerationAndStandsInItsStops) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomWay way = way_of(seed);
    const std::vector<MotionStep> steps = drive_way(way, seed);
    EXPECT_EQ(steps.size(), 30000u);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      ASSERT_LE(steps[i].speed, way.speed + 1e-9);
      ASSERT_LE(std::abs(steps[i].yaw_rate), 4.0);
      const double time = static_cast<double>(i) * kWayStep;
      const double stopped_by = time - way.speed / way.acceleration - 0.1;
      for (const Interval& stop : way.stops) {
        if (stop.holds(time) && stop.holds(stopped_by)) {
          ASSERT_EQ(steps[i].speed, 0.0) << seed << " " << time;
        }
      }
    }
  }
}

TEST(RandomWay, OnlyRobotsThatCanBackUpOrTurnOnTheSpotDo) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed, 0, 1);
    const RandomWay way = draw_way(random, 1.0, 300.0, false, false);
    EXPECT_EQ(way.on_spot_rate, 0.0);
    EXPECT_TRUE(way.reversals.empty());
  }
}

TEST(RandomWay, IsTheSameForTheSameSeed) {
  const RandomWay way = way_of(3);
  const std::vector<MotionStep> a = drive_way(way, 3);
  const std::vector<MotionStep> b = drive_way(way, 3);
  const std::vector<MotionStep> other = drive_way(way, 4);
  EXPECT_EQ(a.back().base_in_map.position(), b.back().base_in_map.position());
  EXPECT_NE(a.back().base_in_map.position(), other.back().base_in_map.position());
}

TEST(RandomWay, StreetsHaveNames) { EXPECT_EQ(to_string(Street::kField), "field"); }

}  // namespace
}  // namespace multipath_localization
