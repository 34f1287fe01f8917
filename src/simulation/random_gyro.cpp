#include "simulation/random_gyro.hpp"

#include <cmath>

#include "simulation/random_ranges.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

RandomGyro draw_gyro(std::uint64_t seed) {
  RandomStream random(seed, 0, kRandomGyroStream);
  RandomGyro gyro;
  gyro.period_ms = one_of(random, {10, 10, 20, 50});
  gyro.bias = draw(random, random_ranges::kGyroBiasSigma) * random.normal();
  gyro.bias_walk = draw(random, random_ranges::kGyroBiasWalk);
  gyro.noise = draw(random, random_ranges::kGyroNoise);
  gyro.scale = random_ranges::kGyroScaleSigma * random.normal();
  return gyro;
}

std::vector<YawRate> read_gyro(const RandomGyro& gyro, const std::vector<MotionStep>& steps,
                               std::uint64_t seed) {
  RandomStream random(seed, 1, kRandomGyroStream);
  const auto stride = static_cast<std::size_t>(gyro.period_ms / kWayStepMs);
  const double period = 1e-3 * gyro.period_ms;
  double bias = gyro.bias;
  std::vector<YawRate> read;
  read.reserve(steps.size() / stride);
  for (std::size_t n = stride; n <= steps.size(); n += stride) {
    bias += gyro.bias_walk * std::sqrt(period) * random.normal();
    const double noise = gyro.noise / std::sqrt(period) * random.normal();
    read.push_back({static_cast<double>(n) * kWayStepMs / 1000.0,
                    steps[n - 1].yaw_rate * (1.0 + gyro.scale) + bias + noise});
  }
  return read;
}

}  // namespace multipath_localization
