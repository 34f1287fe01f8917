#include <gtest/gtest.h>

#include <cmath>

#include "simulation/random_velocity.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {
namespace {

constexpr std::uint64_t kSeeds = 40;

/// Straight to the east at 2 m/s for ten minutes.
std::vector<MotionStep> straight() {
  std::vector<MotionStep> steps;
  for (int i = 1; i <= 60000; ++i) steps.push_back({{0.02 * i, 0.0, 0.0}, 2.0, 0.0});
  return steps;
}

TEST(RandomVelocity, IsOffByWhatWasDrawnAndReflectedAsOften) {
  const std::vector<MotionStep> steps = straight();
  double off = 0.0, drawn = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const RandomVelocity velocity = draw_velocity(seed);
    const std::vector<GnssVelocity> read = read_velocities(velocity, {}, steps, seed);
    const double sigma = std::hypot(velocity.white_sigma, velocity.slow_sigma);
    double far = 0.0, squares = 0.0, near = 0.0;
    for (const GnssVelocity& told : read) {
      const double error = (told.velocity - Eigen::Vector2d(2.0, 0.0)).norm();
      far += error > 5.0 * sigma ? 1.0 : 0.0;
      near += error > 5.0 * sigma ? 0.0 : 1.0;
      squares += error > 5.0 * sigma ? 0.0 : square(error);
    }
    EXPECT_NEAR(std::sqrt(0.5 * squares / near), sigma, 0.5 * sigma) << seed;
    off += far / static_cast<double>(read.size()) / kSeeds;
    drawn += velocity.outlier_share / kSeeds;
  }
  EXPECT_LT(off, 1.1 * drawn);
  EXPECT_GT(off, 0.5 * drawn);
}

TEST(RandomVelocity, IsSilentInOutages) {
  RandomReceiver receiver;
  receiver.outages.push_back({{100.0, 50.0}, 0.0, 0.0});
  for (const GnssVelocity& told : read_velocities(draw_velocity(1), receiver, straight(), 1)) {
    EXPECT_FALSE(told.stamp >= 100.0 && told.stamp < 150.0);
  }
}

}  // namespace
}  // namespace multipath_localization
