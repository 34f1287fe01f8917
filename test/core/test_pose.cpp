#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/random.hpp"
#include "pose_near.hpp"

namespace multipath_localization {
namespace {

Pose2 any_pose(std::uint32_t i) {
  RandomStream random(1, 0, i);
  return {100.0 * random.normal(), 100.0 * random.normal(), wrap_angle(3.0 * random.normal())};
}

TEST(Pose, InverseUndoesCompose) {
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Pose2 pose = any_pose(i);
    EXPECT_TRUE(PoseNear(inverse(pose) * pose, Pose2{}, 1e-12));
    EXPECT_TRUE(PoseNear(pose * inverse(pose), Pose2{}, 1e-12));
  }
}

TEST(Pose, CompositionIsAssociativeAndActsOnPointsInTurn) {
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Pose2 a = any_pose(3 * i);
    const Pose2 b = any_pose(3 * i + 1);
    const Pose2 c = any_pose(3 * i + 2);
    EXPECT_TRUE(PoseNear((a * b) * c, a * (b * c), 1e-10));
    const Eigen::Vector2d point = c.position();
    EXPECT_LT(((a * b) * point - a * (b * point)).norm(), 1e-10);
  }
}

TEST(Pose, ComposedYawIsWrapped) {
  const Pose2 quarter_more_than_half{0.0, 0.0, 0.75 * kPi};
  EXPECT_NEAR((quarter_more_than_half * quarter_more_than_half).yaw, -0.5 * kPi, 1e-12);
  EXPECT_EQ(inverse(Pose2{0.0, 0.0, kPi}).yaw, kPi);
}

TEST(Pose, YawTurnsCounterClockwiseFromEast) {
  const Pose2 facing_north{2.0, 3.0, 0.5 * kPi};
  EXPECT_LT((facing_north * Eigen::Vector2d(1.0, 0.0) - Eigen::Vector2d(2.0, 4.0)).norm(), 1e-12);
  EXPECT_LT((facing_north * Eigen::Vector2d(0.0, 1.0) - Eigen::Vector2d(1.0, 3.0)).norm(), 1e-12);
}

TEST(Pose, RotationIsOrthonormal) {
  for (double yaw = -4.0; yaw < 4.0; yaw += 0.3) {
    const Eigen::Matrix2d R = rotation(yaw);
    EXPECT_LT((R * R.transpose() - Eigen::Matrix2d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
  }
}

TEST(Pose, FiniteOnlyWhenEveryFieldIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE((Pose2{1.0, 2.0, 3.0}.finite()));
  EXPECT_FALSE((Pose2{nan, 2.0, 3.0}.finite()));
  EXPECT_FALSE((Pose2{1.0, infinity, 3.0}.finite()));
  EXPECT_FALSE((Pose2{1.0, 2.0, nan}.finite()));
}

}  // namespace
}  // namespace multipath_localization
