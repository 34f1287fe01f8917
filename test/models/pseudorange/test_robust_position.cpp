#include <gtest/gtest.h>

#include "multipath_localization/models/pseudorange/robust_position.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector3d kAntenna(32.0, -15.0, 12.0);
const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();

std::vector<SatelliteObservation> sky() { return observed(open_sky(), kAntenna, -1369.0, -1362.0); }

TEST(RobustPosition, WithoutOutliersIsLeastSquares) {
  const auto solution = robust_position(sky(), kOrigin);
  ASSERT_TRUE(solution);
  EXPECT_LT((solution->position - kAntenna).norm(), 1e-3);
  EXPECT_NEAR(solution->clock[0], -1369.0, 1e-3);
  EXPECT_EQ(solution->degrees_of_freedom, 8);
}

TEST(RobustPosition, ReflectedSignalsBendItLess) {
  auto observations = sky();
  observations[1].pseudorange += 120.0;
  observations[4].pseudorange += 60.0;
  observations[9].pseudorange += 90.0;
  const auto plain = solve_position(observations, declared_weights(observations), kOrigin);
  const auto robust = robust_position(observations, kOrigin);
  ASSERT_TRUE(plain && robust);
  EXPECT_GT((plain->position - kAntenna).norm(), 20.0);
  EXPECT_LT((robust->position - kAntenna).norm(), 4.0);
}

TEST(RobustPosition, FindsNothingWhereThereIsNone) {
  auto observations = sky();
  observations.resize(3);
  EXPECT_FALSE(robust_position(observations, kOrigin));
  EXPECT_FALSE(robust_position({}, kOrigin));
}

TEST(Residuals, AreWhatRangeAndClockLeave) {
  auto observations = sky();
  const auto solution = robust_position(observations, kOrigin);
  ASSERT_TRUE(solution);
  observations[2].pseudorange += 7.0;
  observations[10].pseudorange -= 3.0;
  const std::vector<double> left = residuals(observations, *solution);
  ASSERT_EQ(left.size(), observations.size());
  EXPECT_NEAR(left[2], 7.0, 1e-3);
  EXPECT_NEAR(left[10], -3.0, 1e-3);
  EXPECT_NEAR(left[0], 0.0, 1e-3);
}

}  // namespace
}  // namespace multipath_localization
