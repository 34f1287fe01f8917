#include <gtest/gtest.h>

#include "../../core/pose_near.hpp"
#include "ros/localization_node/correction_slew.hpp"

namespace multipath_localization {
namespace {

const Pose2 kBase{300.0, -200.0, 0.7};  ///< in odom

/// Where the robot is shown in map.
Pose2 shown(CorrectionSlew& slew, const Pose2& odom_in_map, double stamp, const Pose2& base_in_odom = kBase) {
  return slew.follow(odom_in_map, base_in_odom, stamp) * base_in_odom;
}

TEST(CorrectionSlew, IsOffByDefault) {
  CorrectionSlew slew(SlewParameters{});
  slew.follow({1.0, 2.0, 0.3}, kBase, 1.0);
  const Pose2 other{50.0, 20.0, -3.0};
  EXPECT_TRUE(PoseNear(slew.follow(other, kBase, 1.1), other, 0.0));
}

TEST(CorrectionSlew, MovesTheRobotNoFasterThanAskedFor) {
  CorrectionSlew slew({0.5, 0.0});
  const Pose2 before = shown(slew, {}, 10.0);
  const Pose2 after = shown(slew, {3.0, -4.0, 0.0}, 11.0);
  EXPECT_NEAR((after.position() - before.position()).norm(), 0.5, 1e-9);
  for (int i = 2; i <= 10; ++i) slew.follow({3.0, -4.0, 0.0}, kBase, 10.0 + i);
  EXPECT_TRUE(PoseNear(slew.follow({3.0, -4.0, 0.0}, kBase, 21.0), Pose2{3.0, -4.0, 0.0}, 0.0))
      << "gets there";
}

TEST(CorrectionSlew, TurnsTheRobotAboutItselfNoFasterThanAskedFor) {
  CorrectionSlew slew({0.0, 0.1});
  const Pose2 before = shown(slew, {0.0, 0.0, 3.0}, 10.0);
  const Pose2 turned = Pose2{before.x, before.y, before.yaw + 1.0} * inverse(kBase);
  const Pose2 after = shown(slew, turned, 10.5);
  EXPECT_TRUE(PoseNear(after, Pose2{before.x, before.y, before.yaw + 0.05}, 1e-9));
}

TEST(CorrectionSlew, LetsOdometryGoOnAsItDoes) {
  CorrectionSlew slew({0.5, 0.1});
  const Pose2 odom_in_map{3.0, 1.0, 0.2};
  slew.follow(odom_in_map, kBase, 10.0);
  const Pose2 driven = kBase * Pose2{2.0, 0.0, 0.5};
  EXPECT_TRUE(PoseNear(shown(slew, odom_in_map, 10.1, driven), odom_in_map * driven, 1e-12));
}

TEST(CorrectionSlew, JumpsWhereToldTo) {
  CorrectionSlew slew({0.5, 0.1});
  slew.follow({}, kBase, 10.0);
  slew.jump();
  const Pose2 far{100.0, 0.0, 1.0};
  EXPECT_TRUE(PoseNear(slew.follow(far, kBase, 10.1), far, 0.0));
  EXPECT_FALSE(PoseNear(slew.follow({}, kBase, 10.2), Pose2{}, 1.0));
}

TEST(CorrectionSlew, DoesNotMoveWithoutTime) {
  CorrectionSlew slew({0.5, 0.1});
  slew.follow({}, kBase, 10.0);
  for (const double stamp : {10.0, 9.0}) {
    EXPECT_TRUE(PoseNear(slew.follow({5.0, 5.0, 1.0}, kBase, stamp), Pose2{}, 1e-9)) << stamp;
  }
}

}  // namespace
}  // namespace multipath_localization
