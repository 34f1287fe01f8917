#include <gtest/gtest.h>

#include "multipath_localization/models/pseudorange/one_sided_position.hpp"
#include "sky.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector3d kAntenna(320.0, -150.0, 12.0);

double horizontal_error(const PseudorangeSolution& solution) {
  return (solution.position - kAntenna).head<2>().norm();
}

TEST(OneSidedPosition, IsLeastSquaresWhereNothingIsReflected) {
  const auto sky = observed(open_sky(), kAntenna, -136902.0, -136897.0);
  const auto solution = one_sided_position(sky, declared_weights(sky), {}, Eigen::Vector3d::Zero());
  ASSERT_TRUE(solution);
  EXPECT_LT((solution->position - kAntenna).norm(), 1e-3);
}

TEST(OneSidedPosition, DoubtsLateSignals) {
  auto sky = observed(open_sky(), kAntenna, 0.0, 5.0);
  for (const std::size_t late : {0U, 1U, 9U, 3U}) sky[late].pseudorange += 60.0;
  const auto weights = declared_weights(sky);
  EXPECT_GT(horizontal_error(*solve_position(sky, weights, kAntenna)), 15.0);
  EXPECT_LT(horizontal_error(*one_sided_position(sky, weights, {}, Eigen::Vector3d::Zero())), 1.5);
}

TEST(OneSidedPosition, DoubtsLateMoreThanEarly) {
  auto late = observed(open_sky(), kAntenna, 0.0, 0.0);
  auto early = late;
  late[0].pseudorange += 25.0;
  early[0].pseudorange -= 25.0;
  const auto weights = declared_weights(late);
  EXPECT_LT(2.0 * horizontal_error(*one_sided_position(late, weights, {}, kAntenna)),
            horizontal_error(*one_sided_position(early, weights, {}, kAntenna)));
}

TEST(OneSidedPosition, LeavesOutWhatHasNoWeight) {
  auto sky = observed(open_sky(), kAntenna, 0.0, 0.0);
  auto weights = declared_weights(sky);
  sky[4].pseudorange = 1e300;
  weights[4] = 0.0;
  EXPECT_LT(horizontal_error(*one_sided_position(sky, weights, {}, kAntenna)), 1e-3);
}

TEST(OneSidedPosition, OneAbsurdPseudorangeHarmsNothing) {
  for (const double error : {1e300, -1e12, 9e5, -2e4}) {
    auto sky = observed(open_sky(), kAntenna, 3e5, 3e5);
    sky[4].pseudorange += error;
    const auto solution = one_sided_position(sky, declared_weights(sky), {}, Eigen::Vector3d::Zero());
    ASSERT_TRUE(solution);
    EXPECT_LT(horizontal_error(*solution), 1.0);
  }
}

TEST(OneSidedPosition, NeedsASatelliteToContradict) {
  const auto sky = observed(open_sky(), kAntenna, 0.0, 0.0);
  const std::vector<SatelliteObservation> five = {sky[0], sky[1], sky[2], sky[3], sky[5]};
  const std::vector<SatelliteObservation> four(five.begin(), five.end() - 1);
  EXPECT_TRUE(one_sided_position(five, declared_weights(five), {}, kAntenna));
  EXPECT_FALSE(one_sided_position(four, declared_weights(four), {}, kAntenna));
  EXPECT_FALSE(one_sided_position({}, {}, {}, kAntenna));
}

}  // namespace
}  // namespace multipath_localization
