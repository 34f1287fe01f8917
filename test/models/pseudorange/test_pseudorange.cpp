#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector3d kAntenna(320.0, -150.0, 12.0);
constexpr double kGpsClock = -136902.0;
constexpr double kGlonassClock = -136897.0;

double clock_of(const PseudorangeSolution& solution, Constellation constellation) {
  return solution.clock[static_cast<std::size_t>(constellation)];
}

TEST(LineOfSight, PointsToTheSatellite) {
  const LineOfSight sight =
      line_of_sight(satellite(Constellation::kGps, 1, 90.0, 30.0), Eigen::Vector3d::Zero());
  EXPECT_NEAR(sight.range, 2.2e7, 1e-6);
  EXPECT_LT((sight.direction - Eigen::Vector3d(std::sqrt(0.75), 0.0, 0.5)).norm(), 1e-12);
}

TEST(SolveGeodetic, GivesNothingWhereSatellitesLeadToNoPlace) {
  auto sky = observed(open_sky(), kAntenna, kGpsClock, kGlonassClock);
  const LocalFrame map(Geodetic{52.5, 13.4, 40.0});
  EXPECT_TRUE(solve_geodetic(sky, map));
  sky[2].position.x() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(solve_geodetic(sky, map));
}

TEST(SolvePosition, RecoversPositionAndClocksFromFarOff) {
  const auto sky = observed(open_sky(), kAntenna, kGpsClock, kGlonassClock);
  const auto solution = solve_position(sky, declared_weights(sky), {5e4, -8e4, -3e4});
  ASSERT_TRUE(solution);
  EXPECT_LT((solution->position - kAntenna).norm(), 1e-3);
  EXPECT_NEAR(clock_of(*solution, Constellation::kGps), kGpsClock, 1e-3);
  EXPECT_NEAR(clock_of(*solution, Constellation::kGlonass), kGlonassClock, 1e-3);
  EXPECT_TRUE(std::isnan(clock_of(*solution, Constellation::kGalileo)));
  EXPECT_EQ(solution->used, 13);
  EXPECT_EQ(solution->degrees_of_freedom, 8);
  EXPECT_NEAR(solution->weighted_square_sum, 0.0, 1e-6);
}

TEST(SolvePosition, CovarianceAndResidualsAreWhatTheNoiseMakesThem) {
  double nees = 0.0;
  double squares = 0.0;
  const int runs = 400;
  for (int run = 0; run < runs; ++run) {
    auto sky = observed(open_sky(), kAntenna, kGpsClock, kGlonassClock);
    RandomStream random(5, static_cast<std::uint32_t>(run), 0);
    for (SatelliteObservation& observation : sky) {
      observation.sigma = 3.0;
      observation.pseudorange += 3.0 * random.normal();
    }
    const auto solution = solve_position(sky, declared_weights(sky), Eigen::Vector3d::Zero());
    ASSERT_TRUE(solution);
    const Eigen::Vector3d error = solution->position - kAntenna;
    nees += error.dot(solution->covariance.inverse() * error) / runs;
    squares += solution->weighted_square_sum / runs;
  }
  EXPECT_NEAR(nees, 3.0, 0.4);
  EXPECT_NEAR(squares, 8.0, 0.7);
}

TEST(SolvePosition, LeavesOutWhatHasNoWeight) {
  auto sky = observed(open_sky(), kAntenna, kGpsClock, kGlonassClock);
  std::vector<double> weights = declared_weights(sky);
  sky[2].pseudorange += 80.0;
  EXPECT_GT((solve_position(sky, weights, kAntenna)->position - kAntenna).norm(), 5.0);
  weights[2] = 0.0;
  EXPECT_LT((solve_position(sky, weights, kAntenna)->position - kAntenna).norm(), 1e-3);
}

TEST(SolvePosition, OneThatClaimsMillimetresDoesNotDecideAlone) {
  std::vector<SatelliteObservation> sky = observed(open_sky(), kAntenna, 0.0, 0.0);
  sky[2].sigma = 1e-3;
  sky[2].pseudorange += 10.0;
  const auto solution = solve_position(sky, declared_weights(sky), Eigen::Vector3d::Zero());
  ASSERT_TRUE(solution);
  EXPECT_LT((solution->position - kAntenna).norm(), 20.0);
}

TEST(SolvePosition, NeedsAsManySatellitesAsUnknowns) {
  auto sky = observed(open_sky(), kAntenna, kGpsClock, kGlonassClock);
  std::vector<SatelliteObservation> few = {sky[0], sky[2], sky[5], sky[8], sky[10]};  // 3 + 2 clocks
  EXPECT_TRUE(solve_position(few, declared_weights(few), kAntenna));
  few.pop_back();
  EXPECT_FALSE(solve_position(few, declared_weights(few), kAntenna));
  EXPECT_FALSE(solve_position({}, {}, kAntenna));
}

TEST(SolvePosition, RefusesAGeometryThatLeavesSomethingUndetermined) {
  std::vector<SatelliteObservation> twins(6, satellite(Constellation::kGps, 1, 30.0, 40.0));
  EXPECT_FALSE(solve_position(twins, declared_weights(twins), Eigen::Vector3d::Zero()));
}

TEST(SolvePosition, RefusesWhatIsNotFinite) {
  auto sky = observed(open_sky(), kAntenna, kGpsClock, kGlonassClock);
  sky[0].pseudorange = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solve_position(sky, declared_weights(sky), kAntenna));
}

TEST(SolveGeodetic, NeedsNoDatumNearby) {
  const LocalFrame here(Geodetic{52.5, 13.4, 80.0});
  const LocalFrame elsewhere(Geodetic{-33.0, 151.0, 0.0});
  auto sky = observed(open_sky(), kAntenna, kGpsClock, kGlonassClock);
  for (SatelliteObservation& observation : sky) {
    observation.position = elsewhere.satellite_to_map(here.satellite_to_ecef(observation.position));
  }
  const auto place = solve_geodetic(sky, elsewhere);
  ASSERT_TRUE(place);
  EXPECT_LT((here.to_map(*place) - kAntenna.head<2>()).norm(), 0.01);
  EXPECT_NEAR(place->altitude, 80.0 + kAntenna.z(), 0.02);
  sky.resize(3);
  EXPECT_FALSE(solve_geodetic(sky, elsewhere));
}

}  // namespace
}  // namespace multipath_localization
