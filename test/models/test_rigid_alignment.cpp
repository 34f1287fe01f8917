#include <gtest/gtest.h>

#include "multipath_localization/models/rigid_alignment.hpp"

namespace multipath_localization {
namespace {

constexpr double kLength = 12.0;
constexpr double kFixSigma = 0.3;
constexpr double kFloor = 0.01;

/// Drives a curve from `base` on, with a faultless fix every 0.2 s.
Pose2 drive(RigidAlignment& alignment, Pose2 base, double duration, double speed, double yaw_rate = 0.1) {
  for (int i = 0; i < std::lround(duration / 0.2); ++i) {
    const OdometryIncrement u{0.0, 0.2, speed, yaw_rate};
    base = base * displacement(u);
    alignment.add(u);
    alignment.add(base.position());
  }
  return base;
}

TEST(RigidAlignment, FindsAnyHeadingFromDeadReckoningAndFixes) {
  for (double yaw = -3.0; yaw < 3.2; yaw += 0.5) {
    RigidAlignment alignment(kLength, kFixSigma, kFloor);
    const Pose2 now = drive(alignment, {5.0, -3.0, yaw}, 10.0, 1.5);
    ASSERT_TRUE(alignment.heading().has_value());
    EXPECT_NEAR(angle_difference(alignment.heading()->yaw, now.yaw), 0.0, 1e-9);
  }
}

TEST(RigidAlignment, FindsItInReverse) {
  RigidAlignment alignment(kLength, kFixSigma, kFloor);
  const Pose2 now = drive(alignment, {5.0, -3.0, 1.0}, 10.0, -1.5);
  ASSERT_TRUE(alignment.heading().has_value());
  EXPECT_NEAR(angle_difference(alignment.heading()->yaw, now.yaw), 0.0, 1e-9);
}

TEST(RigidAlignment, IsNeverSurerThanNoiseAndFloorAllow) {
  RigidAlignment alignment(kLength, kFixSigma, kFloor);
  drive(alignment, Pose2{}, 20.0, 1.5, 0.0);
  const double spread =
      kLength * kLength / 12.0 * (kLength / 0.3 + 1.0);  // of points evenly along the window
  EXPECT_NEAR(alignment.heading()->variance, kFloor + 2.0 * kFixSigma * kFixSigma / spread, 1e-3);
  EXPECT_GT(alignment.heading()->variance, kFloor);
}

TEST(RigidAlignment, SaysNothingBeforeItsLengthIsDriven) {
  RigidAlignment alignment(kLength, kFixSigma, kFloor);
  drive(alignment, Pose2{}, 4.0, 1.5);
  EXPECT_FALSE(alignment.heading().has_value());
}

TEST(RigidAlignment, SaysNothingAboutFixesThatDoNotMoveAsTheRobotDoes) {
  RigidAlignment alignment(kLength, kFixSigma, kFloor);
  for (int i = 0; i < 60; ++i) {
    alignment.add(OdometryIncrement{0.0, 0.2, 1.5, 0.0});
    alignment.add(Eigen::Vector2d(1.0, 2.0));
  }
  EXPECT_FALSE(alignment.heading().has_value());
}

TEST(RigidAlignment, ForgetsOnClear) {
  RigidAlignment alignment(kLength, kFixSigma, kFloor);
  drive(alignment, Pose2{}, 20.0, 1.5);
  alignment.clear();
  EXPECT_FALSE(alignment.heading().has_value());
}

}  // namespace
}  // namespace multipath_localization
