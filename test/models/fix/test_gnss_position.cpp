#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/fix/gnss_position.hpp"

namespace multipath_localization {
namespace {

const Eigen::Matrix2d kUndeclared = Eigen::Matrix2d::Zero();

TEST(BelievedCovariance, HoldsPrincipalAxesBetweenFloorAndCap) {
  DeclaredCovarianceParameters parameters;
  parameters.fix_sigma_floor = 0.5;
  parameters.fix_sigma_cap = 10.0;
  const Eigen::Matrix2d turn = rotation(0.7);
  const Eigen::Matrix2d declared = turn * Eigen::Vector2d(1e-4, 1e6).asDiagonal() * turn.transpose();
  const Eigen::Matrix2d expected = turn * Eigen::Vector2d(0.25, 100.0).asDiagonal() * turn.transpose();
  EXPECT_TRUE(believed_covariance(declared, parameters).isApprox(expected, 1e-6));
  const Eigen::Matrix2d sound = turn * Eigen::Vector2d(1.0, 9.0).asDiagonal() * turn.transpose();
  EXPECT_TRUE(believed_covariance(sound, parameters).isApprox(sound, 1e-12));
}

TEST(BelievedCovariance, ZeroMeansUnknown) {
  const DeclaredCovarianceParameters parameters;
  EXPECT_TRUE(believed_covariance(kUndeclared, parameters).isApprox(9.0 * Eigen::Matrix2d::Identity()));
}

TEST(AntennaJacobian, EqualsCentralDifferences) {
  const Eigen::Vector2d antenna(-1.2, 0.4);
  const Pose2 pose{3.0, 4.0, 2.0};
  constexpr double kStep = 1e-6;
  const auto H = antenna_jacobian(pose, antenna);
  const Eigen::Vector2d by_yaw = (Pose2{pose.x, pose.y, pose.yaw + kStep} * antenna -
                                  Pose2{pose.x, pose.y, pose.yaw - kStep} * antenna) /
                                 (2.0 * kStep);
  EXPECT_TRUE(H.col(2).isApprox(by_yaw, 1e-8));
  EXPECT_TRUE((H.leftCols<2>() == Eigen::Matrix2d::Identity()));
}

}  // namespace
}  // namespace multipath_localization
