#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/filters/kalman.hpp"

namespace multipath_localization {
namespace {

using Matrix1d = Eigen::Matrix<double, 1, 1>;
using Vector1d = Eigen::Matrix<double, 1, 1>;

template <int Rows, int Columns>
Eigen::Matrix<double, Rows, Columns> random_matrix(RandomStream& random) {
  Eigen::Matrix<double, Rows, Columns> m;
  for (int i = 0; i < Rows; ++i) {
    for (int j = 0; j < Columns; ++j) m(i, j) = random.normal();
  }
  return m;
}

template <int N>
Eigen::Matrix<double, N, N> random_covariance(RandomStream& random) {
  const Eigen::Matrix<double, N, N> root = random_matrix<N, N>(random);
  return root * root.transpose() + 0.01 * Eigen::Matrix<double, N, N>::Identity();
}

TEST(Kalman, ScalarCorrectionIsTheProductOfTwoGaussians) {
  Gaussian<1> belief{Vector1d(2.0), Matrix1d(4.0)};
  const auto result = kalman::correct<1, 1>(belief, Vector1d(5.0 - 2.0), Matrix1d(1.0), Matrix1d(1.0));
  EXPECT_NEAR(belief.mean(0), 2.0 + 3.0 * 0.8, 1e-12);
  EXPECT_NEAR(belief.covariance(0, 0), 0.8, 1e-12);
  EXPECT_NEAR(result.covariance(0, 0), 5.0, 1e-12);
  EXPECT_NEAR(result.nis, 9.0 / 5.0, 1e-12);
  EXPECT_NEAR(result.log_likelihood, -0.5 * (9.0 / 5.0 + std::log(2.0 * kPi * 5.0)), 1e-12);
}

TEST(Kalman, AgreesWithTheInformationForm) {
  for (std::uint32_t step = 0; step < 50; ++step) {
    RandomStream random(1, step, 0);
    Gaussian<5> belief{random_matrix<5, 1>(random), random_covariance<5>(random)};
    const Eigen::Matrix<double, 2, 5> H = random_matrix<2, 5>(random);
    const Eigen::Matrix2d R = random_covariance<2>(random);
    const Eigen::Vector2d z = random_matrix<2, 1>(random);
    const Eigen::Matrix<double, 5, 5> information =
        belief.covariance.inverse() + H.transpose() * R.inverse() * H;
    const Eigen::Matrix<double, 5, 1> vector =
        belief.covariance.inverse() * belief.mean + H.transpose() * R.inverse() * z;
    kalman::correct<5, 2>(belief, z - H * belief.mean, H, R);
    EXPECT_TRUE(belief.covariance.isApprox(information.inverse(), 1e-8));
    EXPECT_TRUE(belief.mean.isApprox(information.inverse() * vector, 1e-7));
  }
}

TEST(Kalman, PredictMapsTheCovarianceAndKeepsItSymmetric) {
  RandomStream random(2, 0, 0);
  Gaussian<3> belief{random_matrix<3, 1>(random), random_covariance<3>(random)};
  const Eigen::Matrix3d F = random_matrix<3, 3>(random);
  const Eigen::Matrix3d Q = random_covariance<3>(random);
  const Eigen::Matrix3d expected = F * belief.covariance * F.transpose() + Q;
  const Eigen::Vector3d mean = F * belief.mean;
  kalman::predict<3>(belief, mean, F, Q);
  EXPECT_EQ(belief.mean, mean);
  EXPECT_TRUE(belief.covariance.isApprox(expected, 1e-12));
  EXPECT_EQ(belief.covariance, belief.covariance.transpose());
}

/// Sharp measurements of nearly the same sum: the short form (I - K H) P turns negative here.
TEST(Kalman, CovarianceStaysPositiveWhereTheShortFormDoesNot) {
  Gaussian<4> belief;
  belief.covariance *= 1e4;
  for (std::uint32_t step = 0; step < 2000; ++step) {
    RandomStream random(3, step, 0);
    const Eigen::Matrix<double, 1, 4> H =
        Eigen::Matrix<double, 1, 4>::Ones() + 1e-4 * random_matrix<1, 4>(random);
    kalman::correct<4, 1>(belief, Vector1d(0.1), H, Matrix1d(1e-6));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(belief.covariance);
    ASSERT_GT(eigen.eigenvalues().minCoeff(), 0.0) << "step " << step;
    ASSERT_EQ(belief.covariance, belief.covariance.transpose());
  }
}

TEST(Kalman, CompareSaysWhatCorrectWillSayAndChangesNothing) {
  RandomStream random(4, 0, 0);
  Gaussian<3> belief{random_matrix<3, 1>(random), random_covariance<3>(random)};
  const Gaussian<3> before = belief;
  const Eigen::Matrix<double, 2, 3> H = random_matrix<2, 3>(random);
  const Eigen::Vector2d y(0.3, -0.4);
  const auto compared = kalman::compare<3, 2>(belief, y, H, Eigen::Matrix2d::Identity());
  EXPECT_EQ(belief.mean, before.mean);
  EXPECT_EQ(belief.covariance, before.covariance);
  const auto corrected = kalman::correct<3, 2>(belief, y, H, Eigen::Matrix2d::Identity());
  EXPECT_EQ(compared.nis, corrected.nis);
  EXPECT_NEAR(compared.nis, y.dot(compared.covariance.inverse() * y), 1e-12);
}

TEST(Kalman, ImpossibleInnovationCovarianceLeavesTheBeliefAlone) {
  Gaussian<2> belief{Eigen::Vector2d(1.0, 2.0), Eigen::Matrix2d::Zero()};
  const Gaussian<2> before = belief;
  const auto result = kalman::correct<2, 2>(belief, Eigen::Vector2d(1.0, 1.0), Eigen::Matrix2d::Identity(),
                                            Eigen::Matrix2d::Zero());
  EXPECT_EQ(belief.mean, before.mean);
  EXPECT_EQ(belief.covariance, before.covariance);
  EXPECT_TRUE(std::isinf(result.nis));
  EXPECT_LT(result.log_likelihood, -1e300);
}

}  // namespace
}  // namespace multipath_localization
