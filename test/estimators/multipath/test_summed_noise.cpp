#include <gtest/gtest.h>

#include <cmath>

#include "estimators/multipath/summed_noise.hpp"

namespace multipath_localization::multipath {
namespace {

const OdometryNoise kSupposed = {0.01, 0.002, 0.03, 0.004, 1.5e-4, 2e-5};

SummedStep ahead(double way) {
  SummedStep step;
  step.way = {way, 0.0};
  step.moved = 1.0;
  step.told_of_turns = true;
  return step;
}

TEST(SummedNoise, GrowsAlongTheWayByItsRootAndAcrossByHalf) {
  SummedNoise noise(kSupposed);
  for (int i = 0; i < 25; ++i) noise.add(ahead(1.0));
  const Eigen::Matrix3d way = noise.total({1.0, 0.0, 0.0});
  EXPECT_NEAR(std::sqrt(way(0, 0)), 5.0 * kSupposed.distance, 1e-12);
  EXPECT_NEAR(std::sqrt(way(1, 1)), 2.5 * kSupposed.distance, 1e-12);
}

TEST(SummedNoise, OfAHeadingMovesTheWayThatFollowsSideways) {
  SummedNoise noise(kSupposed);
  noise.add(ahead(1.0));
  const double yaw_variance = noise.total({})(2, 2);
  noise.add(ahead(100.0));
  EXPECT_NEAR(noise.total({0.0, 1.0, 0.0})(1, 1), 1e4 * yaw_variance, 1e-9);
  EXPECT_NEAR(noise.total({0.0, 1.0, 0.0})(1, 2), 1e2 * yaw_variance, 1e-9);
}

TEST(SummedNoise, OfAGapIsTheSameAllRound) {
  SummedNoise noise(kSupposed);
  noise.add_gap(20.0);
  EXPECT_EQ(noise.total({0.0, 0.0, 0.0})(0, 0), 100.0);
  EXPECT_EQ(noise.total({0.0, 0.0, 0.0})(1, 1), 100.0);
}

TEST(SummedNoise, OfUntoldTurnsEndsWithTheFirstTurn) {
  SummedNoise noise(kSupposed);
  SummedStep step = ahead(1.0);
  step.told_of_turns = false;
  noise.add(step);
  const double untold = noise.untold_turns()(2, 2);
  EXPECT_GT(untold, 0.0);
  noise.add(ahead(1.0));
  EXPECT_EQ(noise.untold_turns()(2, 2), untold);
}

}  // namespace
}  // namespace multipath_localization::multipath
