#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/fix/dual_antenna.hpp"

namespace multipath_localization {
namespace {

/// A pair without errors from a base at a pose.
DualAntennaFix seen_from(const Pose2& base, const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
  DualAntennaFix fixes;
  fixes.left.antenna_in_base = left;
  fixes.right.antenna_in_base = right;
  fixes.left.position = base * left;
  fixes.right.position = base * right;
  fixes.left.covariance = fixes.right.covariance = 1.6e-5 * Eigen::Matrix2d::Identity();
  return fixes;
}

DualAntennaFix across_the_base(const Pose2& base, double baseline) {
  return seen_from(base, {0.0, 0.5 * baseline}, {0.0, -0.5 * baseline});
}

Eigen::Matrix2d diagonal(double east_sigma, double north_sigma) {
  return Eigen::Vector2d(east_sigma * east_sigma, north_sigma * north_sigma).asDiagonal();
}

/// The pair with errors as it declares them; these must be diagonal.
DualAntennaFix noisy(DualAntennaFix fixes, std::uint32_t number) {
  RandomStream random(1, number, 0);
  for (GnssFix* fix : {&fixes.left, &fixes.right}) {
    for (const int axis : {0, 1})
      fix->position(axis) += std::sqrt(fix->covariance(axis, axis)) * random.normal();
  }
  return fixes;
}

Eigen::Vector3d error_of(const DualAntennaPose& told, const Pose2& truth) {
  return {told.pose.x() - truth.x, told.pose.y() - truth.y, angle_difference(told.pose.z(), truth.yaw)};
}

TEST(DualAntennaPose, IsThePoseTheAntennasWereSeenFrom) {
  RandomStream random(1, 0, 0);
  const auto anywhere = [&] {
    return Eigen::Vector2d(4.0 * random.uniform() - 2.0, 4.0 * random.uniform() - 2.0);
  };
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d place = 1000.0 * anywhere();
    const Pose2 truth{place.x(), place.y(), kPi * (2.0 * random.uniform() - 1.0)};
    const Eigen::Vector2d left = anywhere();
    const auto told = dual_antenna_pose(seen_from(truth, left, left + anywhere()), 0.0);
    ASSERT_TRUE(told);
    EXPECT_LT(error_of(*told, truth).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(told->baseline_error, 0.0, 1e-9);
  }
}

TEST(DualAntennaPose, HeadsAlongTheNormalOfAnOrdinaryBaseline) {  // Fig. 1 of [KAM]
  DualAntennaFix fixes = across_the_base({}, 0.3);
  fixes.left.position = {4.85, 2.0};
  fixes.right.position = {5.15, 2.0};
  const Eigen::Vector3d pose = dual_antenna_pose(fixes, 0.0)->pose;
  EXPECT_NEAR(pose.x(), 5.0, 1e-12);
  EXPECT_NEAR(pose.y(), 2.0, 1e-12);
  EXPECT_NEAR(pose.z(), 0.5 * kPi, 1e-12) << "left antenna in the west: heading north";
}

TEST(DualAntennaPose, LeverArmsCarriedBackTellThePoseOfNow) {
  const Pose2 now{3.0, 4.0, 3.0};
  const Pose2 then_in_now{-0.2, 0.05, -0.4};
  const Measurement late =
      carried_back(across_the_base(now * then_in_now, 0.3), [&](double) { return then_in_now; }).value();
  EXPECT_LT(error_of(*dual_antenna_pose(std::get<DualAntennaFix>(late), 0.0), now).cwiseAbs().maxCoeff(),
            1e-12);
}

class BaselineOf : public testing::TestWithParam<double> {};

TEST_P(BaselineOf, GivesTheCovarianceThatErrorsHave) {
  const Pose2 truth{10.0, -5.0, 2.0};
  constexpr std::uint32_t kDraws = 20000;
  DualAntennaFix clean = seen_from(truth, {0.1, 0.5 * GetParam()}, {0.1, -0.5 * GetParam()});
  clean.left.covariance = diagonal(0.004, 0.006);
  clean.right.covariance = diagonal(0.008, 0.003);
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double nis = 0.0;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const auto told = dual_antenna_pose(noisy(clean, i), 0.0);
    const Eigen::Vector3d error = error_of(*told, truth);
    squares += error * error.transpose() / kDraws;
    nis += told->baseline_nis / kDraws;
  }
  const Eigen::Matrix3d declared = dual_antenna_pose(clean, 0.0)->covariance;
  const Eigen::Matrix3d whitened = declared.inverse() * squares;
  EXPECT_NEAR(whitened.trace(), 3.0, 0.06);  // 3.5 sigma
  EXPECT_NEAR(whitened.determinant(), 1.0, 0.06);
  EXPECT_NEAR(nis, 1.0, 0.035);  // chi-square of 1 dof: 3.5 sigma
}

INSTANTIATE_TEST_SUITE_P(Metres, BaselineOf, testing::Values(0.2, 0.3, 0.4));

TEST(DualAntennaPose, HeadingIsTheBetterTheLongerTheBaseline) {
  const auto heading_sigma = [](double baseline) {
    return std::sqrt(dual_antenna_pose(across_the_base({}, baseline), 0.0)->covariance(2, 2));
  };
  EXPECT_NEAR(heading_sigma(0.3), 0.004 * std::sqrt(2.0) / 0.3,
              1e-6);  // 0.0189: Eq. (12) of [KAM] has 0.0186
  EXPECT_NEAR(heading_sigma(0.2) / heading_sigma(0.4), 2.0, 1e-9);
}

TEST(DualAntennaPose, TakesThePlaceAlongTheBaselineFromTheBetterAntenna) {
  DualAntennaFix clean = across_the_base({0.0, 0.0, 0.0}, 0.4);  // baseline to the north
  clean.left.covariance = diagonal(0.5, 0.5);
  clean.right.covariance = diagonal(0.01, 0.01);
  const auto told = dual_antenna_pose(clean, 0.0);
  EXPECT_NEAR(std::sqrt(told->covariance(1, 1)), 0.01, 1e-4);
  EXPECT_NEAR(std::sqrt(told->covariance(0, 0)), 0.25, 0.01) << "across it nothing is known better";
  clean.left.position.y() += 1.0;
  EXPECT_NEAR(dual_antenna_pose(clean, 0.0)->pose.y(), 0.0, 1e-3);
}

TEST(DualAntennaPose, ShowsAnAntennaThatIsOff) {
  DualAntennaFix fixes = across_the_base({1.0, 2.0, 0.5}, 0.3);
  fixes.left.position = fixes.right.position + 1.2 * (fixes.left.position - fixes.right.position);
  EXPECT_NEAR(dual_antenna_pose(fixes, 0.0)->baseline_error, 0.06, 1e-12);
  EXPECT_NEAR(dual_antenna_pose(fixes, 0.0)->baseline_nis, 0.06 * 0.06 / 3.2e-5, 1e-6);
  EXPECT_NEAR(dual_antenna_pose(fixes, 0.06)->baseline_nis, 1.0, 0.02)
      << "within what the mounting is known to";
}

TEST(DualAntennaPose, IsNoneWhereNoHeadingCanBeTold) {
  EXPECT_FALSE(dual_antenna_pose(across_the_base({}, 0.0), 0.1));
  EXPECT_FALSE(dual_antenna_pose(across_the_base({}, 0.009), 0.1));
  DualAntennaFix merged = across_the_base({}, 0.3);
  merged.left.position = merged.right.position;
  EXPECT_FALSE(dual_antenna_pose(merged, 10.0));
}

TEST(PoseError, IsThatOfThePaperUnlessToldOtherwise) {  // Eqs. (11), (12) of [KAM]
  const PoseError error{PoseErrorParameters{}};
  EXPECT_EQ(error.mean, Eigen::Vector3d(0.0523096875, -0.0315079375, -0.0287904375));
  EXPECT_EQ(error.covariance(0, 0), 0.0000041093);
  EXPECT_EQ(error.covariance(1, 2), 0.0000322863);
  EXPECT_EQ(error.covariance(2, 2), 0.0003444646);
  EXPECT_LT((error.root * error.root.transpose() - error.covariance).cwiseAbs().maxCoeff(), 1e-18);
}

TEST(PoseError, RefusesWhatIsNoMeanOrCovariance) {
  PoseErrorParameters parameters;
  parameters.mean = {0.0, 0.0};
  EXPECT_THROW(PoseError{parameters}, ParameterError);
  parameters = {};
  parameters.covariance.pop_back();
  EXPECT_THROW(PoseError{parameters}, ParameterError);
  parameters = {};
  parameters.covariance[1] = 1e-6;
  EXPECT_THROW(PoseError{parameters}, ParameterError) << "not symmetric";
  parameters.covariance = {1.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  EXPECT_THROW(PoseError{parameters}, ParameterError) << "indefinite";
  parameters.covariance = std::vector<double>(9, 0.0);
  EXPECT_EQ(PoseError{parameters}.root, Eigen::Matrix3d::Zero()) << "none at all";
}

}  // namespace
}  // namespace multipath_localization
