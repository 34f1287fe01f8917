#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/pseudorange/doppler_velocity.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector3d kAntenna(320.0, -150.0, 12.0);
const Eigen::Vector3d kVelocity(3.0, -4.0, 0.2);
constexpr double kDrift = -33.9;

/// The open sky with the range rates that a receiver at `velocity` measures without error.
std::vector<SatelliteObservation> passing(const Eigen::Vector3d& velocity) {
  std::vector<SatelliteObservation> sky = open_sky();
  for (SatelliteObservation& one : sky) {
    const Eigen::Vector3d direction = (one.position - kAntenna).normalized();
    one.range_rate = (one.velocity - velocity).dot(direction) + kDrift;
  }
  return sky;
}

TEST(DopplerVelocity, IsThatOfTheAntennaWhateverTheDrift) {
  const auto solution = doppler_velocity(passing(kVelocity), kAntenna);
  ASSERT_TRUE(solution);
  EXPECT_LT((solution->velocity - kVelocity).norm(), 1e-9);
}

TEST(DopplerVelocity, CovarianceIsThatOfItsErrors) {
  double nees = 0.0;
  constexpr int kRuns = 400;
  for (int run = 0; run < kRuns; ++run) {
    RandomStream random(1, static_cast<std::uint64_t>(run), 0);
    auto sky = passing(kVelocity);
    for (SatelliteObservation& one : sky) one.range_rate += 0.1 * random.normal();
    const auto solution = doppler_velocity(sky, kAntenna);
    ASSERT_TRUE(solution);
    const Eigen::Vector3d error = solution->velocity - kVelocity;
    nees += error.dot(solution->covariance.inverse() * error) / kRuns;
  }
  EXPECT_NEAR(nees, 3.0, 0.6);
}

TEST(DopplerVelocity, AReflectedSignalBendsItLittle) {
  auto sky = passing(kVelocity);
  sky[3].range_rate += 6.0;
  const auto solution = doppler_velocity(sky, kAntenna);
  ASSERT_TRUE(solution);
  EXPECT_LT((solution->velocity - kVelocity).norm(), 0.1);
}

TEST(DopplerVelocity, ANoisySatelliteCountsLess) {
  auto sky = passing(kVelocity);
  sky[3].range_rate += 0.3;
  const double alike = (doppler_velocity(sky, kAntenna)->velocity - kVelocity).norm();
  sky[3].sigma = 50.0;
  const double told = (doppler_velocity(sky, kAntenna)->velocity - kVelocity).norm();
  EXPECT_LT(told, 0.2 * alike);
}

TEST(DopplerVelocity, NeedsFiveSatellitesWithDopplerAllAround) {
  auto sky = passing(kVelocity);
  sky.resize(5);
  EXPECT_TRUE(doppler_velocity(sky, kAntenna));
  sky[4].range_rate = SatelliteObservation::kUnknown;
  EXPECT_FALSE(doppler_velocity(sky, kAntenna));
  EXPECT_FALSE(doppler_velocity({}, kAntenna));
  const std::vector<SatelliteObservation> same(6, passing(kVelocity)[0]);
  EXPECT_FALSE(doppler_velocity(same, kAntenna));
}

}  // namespace
}  // namespace multipath_localization
