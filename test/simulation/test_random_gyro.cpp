#include <gtest/gtest.h>

#include <cmath>

#include "simulation/random_gyro.hpp"

namespace multipath_localization {
namespace {

TEST(RandomGyro, ReadsTheTurnOfTheWayButForItsOwnErrors) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomGyro gyro = draw_gyro(seed);
    const std::vector<MotionStep> steps(20000, MotionStep{{}, 1.0, 0.3});
    const std::vector<YawRate> read = read_gyro(gyro, steps, seed);
    ASSERT_EQ(read.size(), 20000u * kWayStepMs / static_cast<unsigned>(gyro.period_ms));
    double mean = 0.0;
    for (const YawRate& sample : read) mean += sample.rate / static_cast<double>(read.size());
    const double slack = 5.0 * (gyro.noise + 10.0 * gyro.bias_walk) + 1e-6;
    EXPECT_NEAR(mean, 0.3 * (1.0 + gyro.scale) + gyro.bias, slack) << seed;
  }
}

TEST(RandomGyro, IsTheSameForTheSameSeed) {
  const std::vector<MotionStep> steps(100);
  const std::vector<YawRate> a = read_gyro(draw_gyro(5), steps, 5), b = read_gyro(draw_gyro(5), steps, 5);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].rate, b[i].rate);
  EXPECT_NE(draw_gyro(5).bias, draw_gyro(6).bias);
}

}  // namespace
}  // namespace multipath_localization
