#include <gtest/gtest.h>

#include "simulation/second_receiver.hpp"

namespace multipath_localization {
namespace {

TEST(SecondReceiver, HasAShadowOfItsOwnAndDeclaresNothingOfIt) {
  SecondReceiverParameters parameters;
  parameters.rate = 1.0;
  parameters.sigma_open = parameters.sigma_shadow = 0.01;
  ZoneParameters zone;
  zone.edge_x = 10.0;
  zone.inward = 0.0;
  zone.direction = 0.0;
  zone.bias_cap = 4.0;
  parameters.zones.push_back(zone);
  SecondReceiver receiver(parameters, {}, 1);
  const Eigen::Vector2d antenna(0.0, -0.8);
  const Pose2 open{0.0, 3.0, 0.5};
  const Pose2 shadowed{20.0, 3.0, 0.5};
  const std::vector<GnssFix> first = receiver.step(open, 1.0, 0.1);
  const std::vector<GnssFix> second = receiver.step(shadowed, 2.0, 0.1);
  ASSERT_EQ(first.size(), 1u);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_EQ(first.front().receiver, 1u);
  EXPECT_EQ(first.front().antenna_in_base, antenna);
  EXPECT_LT((first.front().position - open * antenna).norm(), 0.1);
  EXPECT_NEAR((second.front().position - shadowed * antenna).x(), 4.0, 0.1);
  EXPECT_EQ(second.front().covariance, first.front().covariance);
}

TEST(SecondReceiver, SaysNothingUnlessItIsGivenARate) {
  SecondReceiver receiver({}, {}, 1);
  EXPECT_TRUE(receiver.step({}, 1.0, 0.1).empty());
}

}  // namespace
}  // namespace multipath_localization
