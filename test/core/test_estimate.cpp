#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <set>
#include <string>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

TEST(Reason, EachHasATextOfItsOwn) {
  std::set<std::string> texts;
  for (int i = 0; i <= static_cast<int>(Reason::kOverload); ++i) {
    const std::string text(to_string(static_cast<Reason>(i)));
    EXPECT_NE(text, "unknown") << i;
    EXPECT_TRUE(texts.insert(text).second) << text;
  }
}

TEST(Innovation, IsAcceptedForOneReasonOnly) {
  for (int i = 0; i <= static_cast<int>(Reason::kOverload); ++i) {
    const auto reason = static_cast<Reason>(i);
    EXPECT_EQ(refused(reason).accepted(), reason == Reason::kAccepted);
    EXPECT_EQ(refused(reason).reason, reason);
  }
  EXPECT_FALSE(Innovation{}.accepted());
}

TEST(Reason, WhatIsOfNoUseWhateverItHoldsIsNoFault) {
  EXPECT_FALSE(is_fault(Reason::kAccepted));
  EXPECT_FALSE(is_fault(Reason::kUnused));
  EXPECT_FALSE(is_fault(Reason::kNotNeeded));
  EXPECT_FALSE(is_fault(Reason::kRepeated));
  EXPECT_FALSE(is_fault(Reason::kOverload));
  EXPECT_TRUE(is_fault(Reason::kGated));
}

Eigen::MatrixXd random_covariance(RandomStream& random, Eigen::Index size) {
  Eigen::MatrixXd root(size, size);
  for (Eigen::Index i = 0; i < root.size(); ++i) root(i) = random.normal();
  return root * root.transpose();
}

double smallest_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues()(0);
}

TEST(CovarianceOverall, IsACovarianceAsWideAsBothWhateverTheClusters) {
  RandomStream random(1, 0, 0);
  for (int i = 0; i < 200; ++i) {
    PoseEstimate estimate;
    estimate.covariance = random_covariance(random, 3);
    estimate.position_covariance_overall = random_covariance(random, 2);
    const Eigen::Matrix3d overall = covariance_overall(estimate);
    const Eigen::Matrix2d position = overall.topLeftCorner<2, 2>();
    EXPECT_EQ(overall, overall.transpose());
    EXPECT_GT(smallest_eigenvalue(overall), 0.0);
    EXPECT_GE(smallest_eigenvalue(overall - estimate.covariance), -1e-12);
    EXPECT_GE(smallest_eigenvalue(position - estimate.position_covariance_overall), -1e-12);
    EXPECT_NEAR(overall(2, 2), estimate.covariance(2, 2), 1e-12);
    EXPECT_NEAR(overall(0, 2), estimate.covariance(0, 2), 1e-12);
  }
}

TEST(CovarianceOverall, IsThatOfAllClustersWhereThatIsWiderInEveryDirection) {
  PoseEstimate estimate;
  estimate.covariance = Eigen::Vector3d(1.0, 2.0, 0.1).asDiagonal();
  estimate.position_covariance_overall << 4.0, 0.4, 0.4, 5.0;
  EXPECT_TRUE((covariance_overall(estimate).topLeftCorner<2, 2>().isApprox(
      estimate.position_covariance_overall, 1e-12)));
}

TEST(PoseEstimate, CountsForNothingUntilMeasured) {
  EXPECT_FALSE(PoseEstimate{}.valid);
  EXPECT_FALSE(PoseEstimate{}.aligned);
}

}  // namespace
}  // namespace multipath_localization
