#include <gtest/gtest.h>

#include <cmath>

#include "simulation/receiver_schedule.hpp"

namespace multipath_localization {
namespace {

struct Delivered {
  double stamp;
  double time;
};

/// What comes of a fix at every epoch over `duration` [s] of steps of 0.01 s.
std::vector<Delivered> watch(ReceiverSchedule schedule, double duration) {
  std::vector<Delivered> all;
  for (long i = 1; i <= std::lround(duration / 0.01); ++i) {
    const double time = static_cast<double>(i) * 0.01;
    if (schedule.due(time)) {
      GnssFix fix;
      fix.stamp = time;
      schedule.send({fix}, time);
    }
    for (const Measurement& measurement : schedule.take(time)) all.push_back({stamp_of(measurement), time});
  }
  return all;
}

ReceiverParameters at(double rate, double latency, double jitter) {
  ReceiverParameters parameters;
  parameters.rate = rate;
  parameters.latency = latency;
  parameters.latency_jitter = jitter;
  return parameters;
}

TEST(ReceiverSchedule, MeasuresAtItsRateAndDeliversLate) {
  const auto all = watch(ReceiverSchedule(at(10.0, 0.25, 0.0), {}, 1), 10.0);
  ASSERT_EQ(all.size(), 97U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].stamp, 0.1 * static_cast<double>(i + 1), 1e-9);
    EXPECT_NEAR(all[i].time - all[i].stamp, 0.25, 1e-6);
  }
}

TEST(ReceiverSchedule, JitterKeepsTheOrder) {
  const auto all = watch(ReceiverSchedule(at(10.0, 0.1, 0.5), {}, 1), 30.0);
  double longest = 0.0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GT(all[i].stamp, all[i - 1].stamp);
    EXPECT_GE(all[i].time - all[i].stamp, 0.1 - 1e-9);
    longest = std::max(longest, all[i].time - all[i].stamp);
  }
  EXPECT_GT(longest, 0.4);
  EXPECT_LE(longest, 0.62);
}

TEST(ReceiverSchedule, IsSilentInAnOutage) {
  const auto all = watch(ReceiverSchedule(at(5.0, 0.0, 0.0), {{2.0, 3.0}}, 1), 10.0);
  EXPECT_EQ(all.size(), 50U - 15U);
  for (const Delivered& d : all) EXPECT_FALSE(d.stamp > 1.99 && d.stamp < 4.99) << d.stamp;
}

}  // namespace
}  // namespace multipath_localization
