#include <gtest/gtest.h>

#include "estimators/multipath/wheel_fault.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(WheelFault, IsOfAnySize) {
  RandomStream random(1, 1, 1);
  double least = 10.0;
  double largest = 0.0;
  for (int i = 0; i < 500; ++i) {
    const WheelFault fault = draw_wheel_fault(random);
    EXPECT_TRUE(fault.any());
    least = std::min(least, fault.speed);
    largest = std::max(largest, fault.speed);
  }
  EXPECT_LT(least, 0.12);
  EXPECT_GT(largest, 1.7);
}

TEST(WheelFault, OfStandingWheelsLastsLonger) {
  EXPECT_GT(fault_goes_on(3.0, true), fault_goes_on(3.0, false));
  EXPECT_LT(fault_goes_on(60.0, true), 0.01);
}

TEST(WheelFault, MovesARobotAheadRatherThanAside) {
  Hypothesis h;
  h.wheel_fault = {1.0, 0.5};
  RandomStream random(2, 1, 1);
  move_unseen(h, 2.0, 1.0, false, random);
  EXPECT_NEAR(h.covariance(kX, kX), 4.0, 1e-9);
  EXPECT_LT(h.covariance(kY, kY), 0.5 * h.covariance(kX, kX));
  EXPECT_NE(h.mean(kYaw), 0.0);
}

TEST(WheelFault, TurnsNothingThatAGyroSees) {
  Hypothesis h;
  h.wheel_fault = {1.0, 2.0};
  RandomStream random(1, 0, 0);
  move_unseen(h, 2.0, 1.0, true, random);
  EXPECT_EQ(h.mean(kYaw), 0.0);
  EXPECT_EQ(h.covariance(kYaw, kYaw), 0.0);
  EXPECT_GT(h.covariance(kX, kX), 0.0);
}

}  // namespace
}  // namespace multipath_localization::multipath
