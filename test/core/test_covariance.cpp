#include <gtest/gtest.h>

#include "multipath_localization/core/covariance.hpp"

namespace multipath_localization {
namespace {

Eigen::Matrix2d matrix(double xx, double xy, double yx, double yy) {
  return (Eigen::Matrix2d() << xx, xy, yx, yy).finished();
}

TEST(Covariance, SymmetricIsTheMeanWithTheTranspose) {
  EXPECT_EQ(symmetric<2>(matrix(1.0, 2.0, 4.0, 5.0)), matrix(1.0, 3.0, 3.0, 5.0));
}

TEST(Covariance, MayBeSingular) {
  EXPECT_TRUE(positive_semi_definite(Eigen::Matrix2d(Eigen::Matrix2d::Zero())));
  EXPECT_TRUE(positive_semi_definite(matrix(1.0, 2.0, 2.0, 4.0)));
  const Eigen::Vector3d axis(1.0, -2.0, 0.3);
  EXPECT_TRUE(positive_semi_definite(Eigen::Matrix3d(axis * axis.transpose())));
}

TEST(Covariance, HasNoCorrelationAboveOne) {
  EXPECT_FALSE(positive_semi_definite(matrix(1.0, 2.1, 2.1, 4.0)));
  EXPECT_FALSE(positive_semi_definite(matrix(0.0, 1.0, 1.0, 0.0)));
  Eigen::Matrix3d P = Eigen::Matrix3d::Identity();
  P(0, 1) = P(1, 0) = P(0, 2) = P(2, 0) = 0.9;  // each of them may be, both may not
  EXPECT_FALSE(positive_semi_definite(P));
}

TEST(Covariance, HasNoNegativeVariance) {
  EXPECT_FALSE(positive_semi_definite(matrix(1.0, 0.0, 0.0, -1e-9)));
  EXPECT_FALSE(positive_semi_definite(matrix(-1.0, 0.0, 0.0, -1.0)));
}

TEST(Covariance, IsSymmetricButForRounding) {
  EXPECT_TRUE(positive_semi_definite(matrix(1e4, 1.0, 1.0 + 1e-3, 1e4)));
  EXPECT_FALSE(positive_semi_definite(matrix(1e4, 1.0, 1.1, 1e4)));
}

TEST(MeanSigma, IsTheRootOfTheMeanVariance) {
  EXPECT_EQ(mean_sigma(Eigen::Matrix2d(Eigen::Vector2d(1.0, 7.0).asDiagonal())), 2.0);
}

}  // namespace
}  // namespace multipath_localization
