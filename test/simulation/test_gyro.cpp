#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulation/gyro.hpp"

namespace multipath_localization {
namespace {

std::vector<YawRate> read(const GyroParameters& parameters, double yaw_rate,
                          const std::vector<SensorFault>& faults = {}) {
  Gyro gyro(parameters, faults, 3);
  std::vector<YawRate> all;
  for (int i = 1; i <= 1000; ++i) {
    for (const YawRate& sample : gyro.step(yaw_rate, 0.01 * i)) all.push_back(sample);
  }
  return all;
}

TEST(Gyro, IsNotThereWithoutARate) { EXPECT_TRUE(read({}, 0.5).empty()); }

TEST(Gyro, ReadsTheYawRateWithBiasScaleAndNoise) {
  GyroParameters parameters;
  parameters.rate = 50.0;
  parameters.bias = 0.02;
  parameters.bias_sigma = 0.0;
  parameters.scale_error = 0.1;
  parameters.noise = 0.001;
  const std::vector<YawRate> all = read(parameters, 0.5);
  ASSERT_EQ(all.size(), 500u);
  EXPECT_NEAR(all[10].stamp, 0.22, 1e-9);
  double mean = 0.0, squares = 0.0;
  for (const YawRate& sample : all) mean += sample.rate / 500.0;
  for (const YawRate& sample : all) squares += (sample.rate - mean) * (sample.rate - mean) / 500.0;
  EXPECT_NEAR(mean, 0.57, 0.002);
  EXPECT_NEAR(std::sqrt(squares), 0.001 * std::sqrt(50.0), 0.001);
}

TEST(Gyro, IsSpoiltByItsFaults) {
  GyroParameters parameters;
  parameters.rate = 50.0;
  SensorFault reversed;
  reversed.kind = "reversed";
  reversed.start = 5.0;
  const std::vector<YawRate> all = read(parameters, 0.5, {reversed});
  ASSERT_EQ(all.size(), 500u);
  for (const YawRate& sample : all) {
    const bool begun = sample.stamp > 5.0 - 1e-9;
    EXPECT_EQ(std::signbit(sample.rate), begun) << sample.stamp;
  }
}

}  // namespace
}  // namespace multipath_localization
