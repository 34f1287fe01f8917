#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/geodesy.hpp"
#include "simulation/receiver_clock.hpp"

namespace multipath_localization {
namespace {

constexpr double kMillisecond = 1e-3 * kSpeedOfLight;  // [m]

TEST(ReceiverClock, RunsByItsDriftAndIsPutBackByWholeSteps) {
  ReceiverClockParameters parameters;
  parameters.drift_walk = 0.0;
  ReceiverClock clock(parameters, 3);
  const double drift = clock.drift();
  ASSERT_GT(std::abs(drift), 1.0);
  double expected = clock.bias();
  int steered = 0;
  for (int i = 0; i < 20000; ++i) {
    const double before = clock.bias();
    clock.step(1.0);
    expected += drift;
    EXPECT_EQ(clock.drift(), drift);
    EXPECT_LE(std::abs(clock.bias()), 0.5 * kMillisecond);
    const double steps = (expected - clock.bias()) / kMillisecond;
    EXPECT_NEAR(steps, std::round(steps), 1e-6);
    steered += std::abs(clock.bias() - before) > 0.5 * kMillisecond ? 1 : 0;
  }
  EXPECT_EQ(steered, std::lround(std::abs(expected - clock.bias()) / kMillisecond));
  EXPECT_GT(steered, 0);
}

TEST(ReceiverClock, DriftSpreadsBySeedAndWalksWithTime) {
  ReceiverClockParameters parameters;
  parameters.drift_sigma = 30.0;
  parameters.drift_walk = 2.0;
  const int seeds = 500;
  double start = 0.0;
  double walked = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    ReceiverClock clock(parameters, static_cast<std::uint64_t>(seed));
    const double before = clock.drift();
    for (int i = 0; i < 25; ++i) clock.step(1.0);
    start += before * before / seeds;
    walked += (clock.drift() - before) * (clock.drift() - before) / seeds;
  }
  EXPECT_NEAR(std::sqrt(start), 30.0, 4.0);
  EXPECT_NEAR(std::sqrt(walked), 10.0, 1.3);
}

TEST(ReceiverClock, SameSeedSameClock) {
  ReceiverClock one({}, 5);
  ReceiverClock other({}, 5);
  EXPECT_NE(one.bias(), ReceiverClock({}, 6).bias());
  for (int i = 0; i < 10; ++i) {
    one.step(0.1);
    other.step(0.1);
    EXPECT_EQ(one.bias(), other.bias());
  }
}

}  // namespace
}  // namespace multipath_localization
