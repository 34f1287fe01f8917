#include <gtest/gtest.h>

#include <set>

#include "simulation/random_ranges.hpp"
#include "simulation/random_robot.hpp"

namespace multipath_localization {
namespace {

namespace ranges = random_ranges;

template <class Limits>
void expect_within(double value, Limits limits, const std::string& what) {
  EXPECT_GE(value, limits.low * (1.0 - 1e-9)) << what;
  EXPECT_LE(value, limits.high * (1.0 + 1e-9)) << what;
}

TEST(RandomRobot, IsDrawnFromItsRanges) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomRobot robot = draw_robot(seed);
    expect_within(robot.way.speed, ranges::kSpeed, "speed");
    expect_within(robot.way.duration, ranges::kDuration, "duration");
    for (const RandomShadow& shadow : robot.receiver.shadows) {
      expect_within(shadow.bias, ranges::kShadowBias, "bias");
    }
    for (const RandomOutage& outage : robot.receiver.outages) {
      expect_within(outage.when.duration, ranges::kOutage, "outage");
    }
    EXPECT_LE(robot.odometry.tick, ranges::kTick.high);
    EXPECT_LE(robot.receiver.outlier_share, ranges::kOutlierShare.high);
  }
}

TEST(RandomRobot, IsAnotherOneForEachSeedAndTheSameForTheSame) {
  std::set<std::string> robots;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    EXPECT_EQ(describe(draw_robot(seed)), describe(draw_robot(seed)));
    robots.insert(describe(draw_robot(seed)));
  }
  EXPECT_EQ(robots.size(), 30u);
}

TEST(RandomRobot, SaysWhatItIs) {
  RandomRobot robot;
  robot.receiver.levels = {{3.0, 0.0, 1.0, 0.0}};
  robot.receiver.kind = ReceiverKind::kPlain;
  robot.receiver.outages = {{{1.0, 20.0}, 5.0, 4.0}};
  robot.way.speed = 2.0;
  EXPECT_EQ(describe(robot),
            "plain 2.1 m at 5 Hz, declared honest; 2 m/s block, gyro at 50 Hz; outage 20 s then 4 m off");
}

}  // namespace
}  // namespace multipath_localization
