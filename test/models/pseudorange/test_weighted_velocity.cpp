#include <gtest/gtest.h>

#include "models/pseudorange/weighted_velocity.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector3d kAntenna(30.0, -10.0, 2.0);
const Eigen::Vector3d kVelocity(6.0, -3.0, 0.2);

std::vector<SatelliteObservation> moving_sky() {
  return with_doppler(observed(open_sky(), kAntenna, 0.0, 0.0), kAntenna, kVelocity, 130.0);
}

std::optional<Eigen::Vector3d> velocity_of(const std::vector<SatelliteObservation>& sky, double tolerance,
                                           const std::vector<double>& weights) {
  std::vector<Eigen::Vector3d> directions;
  for (const auto& observation : sky) directions.push_back((observation.position - kAntenna).normalized());
  return weighted_velocity(sky, directions, weights, tolerance);
}

TEST(WeightedVelocity, IsExactWithoutNoise) {
  const auto sky = moving_sky();
  for (const double tolerance : {0.0, 0.5}) {
    const auto velocity = velocity_of(sky, tolerance, std::vector<double>(sky.size(), 1.0));
    ASSERT_TRUE(velocity);
    EXPECT_LT((*velocity - kVelocity).norm(), 1e-6);
  }
}

TEST(WeightedVelocity, ToleranceDoubtsAReflectedSignal) {
  auto sky = moving_sky();
  sky[4].range_rate += 8.0;
  const std::vector<double> weights(sky.size(), 1.0);
  EXPECT_GT((*velocity_of(sky, 0.0, weights) - kVelocity).norm(), 1.0);
  EXPECT_LT((*velocity_of(sky, 0.5, weights) - kVelocity).norm(), 0.5);
}

TEST(WeightedVelocity, LeavesOutWhatHasNoWeightOrNoDoppler) {
  auto sky = moving_sky();
  std::vector<double> weights(sky.size(), 1.0);
  sky[2].range_rate += 50.0;
  weights[2] = 0.0;
  sky[5].range_rate = SatelliteObservation::kUnknown;
  EXPECT_LT((*velocity_of(sky, 0.0, weights) - kVelocity).norm(), 1e-6);
}

TEST(WeightedVelocity, NeedsFourSatellitesApart) {
  const auto sky = moving_sky();
  std::vector<double> weights(sky.size(), 0.0);
  for (const std::size_t used : {0U, 2U, 5U}) weights[used] = 1.0;
  EXPECT_FALSE(velocity_of(sky, 0.0, weights));
  weights[7] = 1.0;
  EXPECT_TRUE(velocity_of(sky, 0.0, weights));
  const std::vector<SatelliteObservation> twins(6, sky[0]);
  EXPECT_FALSE(velocity_of(twins, 0.0, std::vector<double>(6, 1.0)));
}

TEST(WeightedVelocity, LeavesOutRangeRatesThatNoClockExplains) {
  auto sky = moving_sky();
  sky[0].range_rate = 1e300;
  sky[7].range_rate = -3e4;
  EXPECT_LT((*velocity_of(sky, 0.0, std::vector<double>(sky.size(), 1.0)) - kVelocity).norm(), 1e-6);
}

TEST(WeightedVelocity, RefusesWhatNoVehicleReaches) {
  const auto sky = with_doppler(observed(open_sky(), kAntenna, 0.0, 0.0), kAntenna, 100.0 * kVelocity, 0.0);
  EXPECT_FALSE(velocity_of(sky, 0.0, std::vector<double>(sky.size(), 1.0)));
}

}  // namespace
}  // namespace multipath_localization
