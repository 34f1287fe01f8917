#include <gtest/gtest.h>

#include "ros/inputs/pose_agreement.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.02;

/// The share of the intervals over which they agree, after two seconds.
double agreed(PoseAgreement& agreement, const OdometryIncrement& by_pose, const OdometryIncrement& by_twist) {
  int count = 0;
  for (int i = 0; i < 600; ++i) count += agreement.agrees(by_pose, by_twist) && i >= 100 ? 1 : 0;
  return count / 500.0;
}

TEST(PoseAgreement, IsOfPosesThatLeadWhereTheTwistLeads) {
  const OdometryIncrement twist{0.0, kStep, 1.0, 0.3, -0.5};
  PoseAgreement alike, far, elsewhere, turning;
  EXPECT_EQ(agreed(alike, {0.0, kStep, 1.03, 0.3, -0.5}, twist), 1.0);
  EXPECT_EQ(agreed(far, {0.0, kStep, 1.3, 0.3, -0.5}, twist), 0.0);
  EXPECT_EQ(agreed(elsewhere, {0.0, kStep, 1.0, 0.3, 0.0}, twist), 0.0);
  EXPECT_EQ(agreed(turning, {0.0, kStep, 1.0, 0.0, -0.5}, twist), 0.0);
}

TEST(PoseAgreement, WaitsASecondAtTheStartAndAfterAJump) {
  PoseAgreement agreement;
  const OdometryIncrement u{0.0, kStep, 1.0, 0.0};
  EXPECT_FALSE(agreement.agrees(u, u));
  for (int i = 0; i < 60; ++i) agreement.agrees(u, u);
  EXPECT_TRUE(agreement.agrees(u, u));
  EXPECT_FALSE(agreement.agrees({0.0, kStep, 20.0, 0.0}, u)) << "0.4 m";
  EXPECT_FALSE(agreement.agrees(u, u));
  for (int i = 0; i < 60; ++i) agreement.agrees(u, u);
  EXPECT_TRUE(agreement.agrees(u, u));
}

TEST(PoseAgreement, IsNotTakenInByBursts) {
  PoseAgreement agreement;
  bool agrees = true;
  for (int i = 0; i < 600; ++i) {
    const double step = i % 6 == 0 ? 0.075 : 0.003;
    const OdometryIncrement by_arrival{0.0, step, 0.0075 / step, 0.0};
    agrees = agreement.agrees(by_arrival, by_arrival) || i < 100;
    EXPECT_TRUE(agrees) << i;
  }
}

}  // namespace
}  // namespace multipath_localization
