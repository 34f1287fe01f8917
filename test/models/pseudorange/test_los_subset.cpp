#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "multipath_localization/models/pseudorange/los_subset.hpp"
#include "multipath_localization/models/pseudorange/signal_weights.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector3d kAntenna(320.0, -150.0, 12.0);
constexpr double kGps = -136902.0;
constexpr double kGlonass = -136909.0;

InterSystemBias separate() { return InterSystemBias(std::numeric_limits<double>::infinity()); }

InterSystemBias tied(double glonass_over_gps) {
  InterSystemBias bias(1e-3);
  PseudorangeSolution solution;
  solution.clock.fill(std::numeric_limits<double>::quiet_NaN());
  solution.clock[0] = 0.0;
  solution.clock[1] = glonass_over_gps;
  bias.adopt(solution);
  return bias;
}

LosSubsetParameters as_printed() {
  LosSubsetParameters parameters;
  parameters.clock = SubsetClock::kReference;
  parameters.lower_threshold = -20.0;
  parameters.upper_threshold = 10.0;
  return parameters;
}

TEST(LosSubset, StepsToWhereThePseudorangesWereMeasured) {
  const auto sky = observed(open_sky(), kAntenna, kGps, kGlonass);
  for (const InterSystemBias& bias : {separate(), tied(kGlonass - kGps)}) {
    LosSubset subset(sky, declared_weights(sky), bias, {});
    for (const Eigen::Vector3d& offset : {Eigen::Vector3d(8.0, -5.0, 4.0), Eigen::Vector3d(0.0, 0.0, 0.0)}) {
      const auto solution = subset.solve(kAntenna + offset);
      ASSERT_TRUE(solution);
      EXPECT_EQ(solution->satellites, 13);
      EXPECT_LT((solution->step + offset).norm(), 1e-3);
      EXPECT_NEAR(solution->mahalanobis_squared, offset.dot(solution->information * offset), 1e-3);
      EXPECT_NEAR(solution->log_determinant, std::log(solution->information.determinant()), 1e-9);
    }
  }
}

TEST(LosSubset, CovarianceIsThatOfLeastSquares) {
  const auto sky = observed(open_sky(), kAntenna, kGps, kGlonass);
  const auto weights = signal_weights(sky);
  LosSubset subset(sky, weights, separate(), {});
  const Eigen::Matrix3d covariance = subset.solve(kAntenna)->information.inverse();
  const Eigen::Matrix3d expected = solve_position(sky, weights, kAntenna)->covariance;
  EXPECT_LT((covariance - expected).norm(), 1e-4 * expected.norm());
}

TEST(LosSubset, KnowingTheOffsetOfAConstellationTellsMore) {
  auto sky = observed(open_sky(), kAntenna, kGps, kGlonass);
  sky.resize(10);  // two of GLONASS, on one side
  const auto weights = declared_weights(sky);
  LosSubset free(sky, weights, separate(), {});
  LosSubset known(sky, weights, tied(kGlonass - kGps), {});
  EXPECT_GT(known.solve(kAntenna)->log_determinant, free.solve(kAntenna)->log_determinant + 0.1);
}

TEST(LosSubset, SelectsWithinTheThresholdsOfEquation6) {
  auto sky = observed(open_sky(), kAntenna, 0.0, 0.0);
  sky[1].pseudorange += 9.9;
  sky[3].pseudorange += 10.1;
  sky[4].pseudorange -= 19.9;
  sky[6].pseudorange -= 20.1;
  LosSubset subset(sky, declared_weights(sky), separate(), as_printed());
  ASSERT_TRUE(subset.solve(kAntenna));
  EXPECT_EQ(subset.solve(kAntenna)->satellites, 11);
  EXPECT_NEAR(subset.excluded_share(), 2.0 / 13.0, 1e-12);
}

TEST(LosSubset, AReflectedReferenceShiftsEveryResidualButNoQuantile) {
  auto sky = observed(open_sky(), kAntenna, 0.0, 0.0);
  sky[2].cn0 = 52.0;
  sky[2].elevation = 1.4;  // the reference
  sky[2].pseudorange += 60.0;
  const auto weights = declared_weights(sky);
  LosSubset printed(sky, weights, separate(), as_printed());
  EXPECT_FALSE(printed.solve(kAntenna));
  LosSubset repaired(sky, weights, separate(), {});
  const auto solution = repaired.solve(kAntenna);
  ASSERT_TRUE(solution);
  EXPECT_EQ(solution->satellites, 12);
  EXPECT_LT(solution->step.norm(), 1e-3);
}

TEST(LosSubset, ReferenceIsAHighAndStrongSatellite) {
  auto sky = observed(open_sky(), kAntenna, 0.0, 0.0);
  for (auto& observation : sky) observation.cn0 = 38.0;
  sky[6].cn0 = 45.0;
  sky[6].elevation = 1.2;
  sky[6].pseudorange -= 15.0;
  LosSubset subset(sky, declared_weights(sky), separate(), as_printed());
  EXPECT_FALSE(subset.solve(kAntenna));  // all others are 15 m late against it
}

TEST(LosSubset, ResidualsOfConstellationsTellTheirOffset) {
  const auto sky = observed(open_sky(), kAntenna, 0.0, 6.0);
  LosSubset subset(sky, declared_weights(sky), tied(2.0), {});
  ASSERT_TRUE(subset.solve(kAntenna));
  const auto gps = subset.clock_residual(Constellation::kGps);
  const auto glonass = subset.clock_residual(Constellation::kGlonass);
  ASSERT_TRUE(gps && glonass);
  EXPECT_NEAR(glonass->mean - gps->mean, 4.0, 1e-3);
  EXPECT_NEAR(glonass->variance, 5.0, 1e-9);
  EXPECT_FALSE(subset.clock_residual(Constellation::kBeidou));
}

TEST(LosSubset, VelocityIsThatOfItsSatellites) {
  const Eigen::Vector3d velocity(5.0, 2.0, 0.0);
  auto sky = with_doppler(observed(open_sky(), kAntenna, 0.0, 0.0), kAntenna, velocity, 30.0);
  sky[1].pseudorange += 70.0;
  sky[1].range_rate += 9.0;
  LosSubset subset(sky, declared_weights(sky), separate(), {});
  ASSERT_TRUE(subset.solve(kAntenna));
  EXPECT_LT((*subset.velocity(0.0) - velocity).norm(), 1e-6);
}

TEST(LosSubset, NeedsASatelliteForEachUnknown) {
  const auto sky = observed(open_sky(), kAntenna, 0.0, 0.0);
  const std::vector<SatelliteObservation> five = {sky[0], sky[2], sky[5], sky[8], sky[10]};
  const std::vector<SatelliteObservation> four(five.begin(), five.end() - 1);
  LosSubset enough(five, declared_weights(five), separate(), {});
  LosSubset few(four, declared_weights(four), separate(), {});
  EXPECT_TRUE(enough.solve(kAntenna));
  EXPECT_FALSE(few.solve(kAntenna));
  const std::vector<SatelliteObservation> twins(8, sky[0]);
  LosSubset flat(twins, declared_weights(twins), separate(), {});
  EXPECT_FALSE(flat.solve(kAntenna));
}

}  // namespace
}  // namespace multipath_localization
